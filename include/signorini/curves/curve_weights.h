#ifndef signorini_curves_curve_weights_h
#define signorini_curves_curve_weights_h

#include <signorini/curves/curve.h>

#include <array>
#include <vector>

namespace Signorini
{
  /**
   * A point of a curve through nodes x_j, for each component c by itself:
   * y_c = sum_j phi_j[c] x_j[c], y'_c = sum_j dphi_j[c] x_j[c], with
   * sum_j phi_j = 1 and sum_j dphi_j = 0. Both components have the same weights
   * except next to a symmetric end, where the mirror tells them apart.
   */
  struct NodalWeights
  {
    std::vector<unsigned int>         nodes; // at most 4
    std::vector<dealii::Tensor<1, 2>> phi;
    std::vector<dealii::Tensor<1, 2>> dphi; // derivative to xi
  };

  /**
   * How the control points of a curve hang on nodes that move: each is a fixed
   * linear combination of at most 4 of them. The nodes are counted along the
   * curve, in the order in which their reference positions were given; the
   * segment s begins at node s and ends at node s + 1 (the last segment of a
   * closed curve ends at node 0).
   */
  class CurveWeights
  {
  public:
    /**
     * Parameters of the nodes, from which the tangents are found. On equal
     * distances both are the same; where distances change abruptly from wide to
     * narrow by a factor of 10 or more the uniform curve turns back, the
     * centripetal one does not: that is the one to take.
     */
    enum class Knots
    {
      uniform,    // steps of one: [MC, eq. 33], Catmull-Rom
      centripetal // steps of the square root of the reference distance
    };

    CurveWeights() = default;

    /**
     * Overhauser's curve: the tangent at a node is that of the parabola through
     * it and its two neighbours; with steps h_1 and h_2 before and after it,
     *
     *   m = (h_2 (x_1 - x_0)/h_1 + h_1 (x_2 - x_1)/h_2) / (h_1 + h_2),
     *
     * and p_1 = x_1 + h_2 m/3 [MC, eq. 34]. At the end of an open chain it is
     * the tangent of the parabola through the last three nodes, so that the
     * last segment is this parabola; two nodes alone give a straight segment.
     * Where neighbouring chords turn by more than the feature angle the node is
     * a corner: both sides end there as open chains do. Beyond a symmetric end
     * its neighbour is mirrored, x_c -> 2 e_c - x_c, which makes the tangent
     * normal to the line of symmetry exactly.
     *
     * @param reference     positions that decide on corners and knots, m; a
     * closed curve does not repeat its first node
     * @param feature_angle degrees
     * @throws InputError for less than two nodes (closed: three) or neighbours
     * at the same place.
     */
    static CurveWeights
    overhauser(const std::vector<dealii::Point<2>> &reference,
               const bool                           is_closed,
               const Knots                          knots,
               const double                         feature_angle,
               const std::array<CurveEnd, 2>       &ends = {});

    /** Straight segments, every node a corner. @throws InputError as above. */
    static CurveWeights
    facets(const std::vector<dealii::Point<2>> &reference,
           const bool                           is_closed,
           const std::array<CurveEnd, 2>       &ends = {});

    /**
     * The boundary of the elements themselves: facets, or for degree 2 the
     * parabola through three nodes, with a corner at each end of an element.
     * With these weights a uniform pressure gives the nodal forces that the
     * elements expect. The first node is the start of an element.
     * @throws InputError as above.
     */
    static CurveWeights
    trace(const std::vector<dealii::Point<2>> &reference,
          const bool                           is_closed,
          const unsigned int                   degree,
          const std::array<CurveEnd, 2>       &ends = {});

    unsigned int
    n_nodes() const
    {
      return n_nodes_;
    }

    unsigned int
    n_segments() const
    {
      return segments_.size();
    }

    /** The nodes on which a segment hangs. */
    const std::vector<unsigned int> &
    nodes_of(const unsigned int segment) const
    {
      return segments_[segment].nodes;
    }

    /** The segments that hang on a node. */
    std::vector<unsigned int>
    segments_of(const unsigned int node) const;

    /** The curve for positions of the nodes. */
    Curve
    curve(const std::vector<dealii::Point<2>> &positions) const;

    /** New control points of all segments. */
    void
    update(const std::vector<dealii::Point<2>> &positions, Curve &curve) const;

    /** New control points of some segments. */
    void
    update(const std::vector<dealii::Point<2>> &positions,
           const std::vector<unsigned int>     &segments,
           Curve                               &curve) const;

    /** The weights of the nodes at a place. */
    NodalWeights
    at(const CurveParameter &place) const;

  private:
    struct Segment
    {
      std::vector<unsigned int> nodes;
      // Of control point i on node j.
      std::array<std::vector<dealii::Tensor<1, 2>>, 4> weights;
    };

    friend class OverhauserBuilder;

    CurveWeights(const std::vector<dealii::Point<2>> &reference,
                 const bool                           is_closed,
                 const std::array<CurveEnd, 2>       &ends);

    BezierSegment
    segment(const std::vector<dealii::Point<2>> &positions,
            const unsigned int                   s) const;

    unsigned int            n_nodes_ = 0;
    std::vector<Segment>    segments_;
    std::vector<bool>       is_corner_;
    bool                    is_closed_ = false;
    bool                    is_trace_  = false; // of elements of degree 2
    std::array<CurveEnd, 2> ends_;
  };
} // namespace Signorini

#endif
