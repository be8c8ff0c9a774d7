#ifndef signorini_curves_curve_search_h
#define signorini_curves_curve_search_h

#include <signorini/curves/curve_projection.h>
#include <signorini/curves/segment_tree.h>

#include <functional>
#include <limits>
#include <optional>
#include <vector>

namespace Signorini
{
  /** Which points of a curve a contactor point may meet. */
  struct CurveQuery
  {
    /** Points farther away are not looked for, m. */
    double search_distance = std::numeric_limits<double>::infinity();

    /** Deeper inside, x is taken to be on another side of the body, m. */
    double penetration_limit = std::numeric_limits<double>::infinity();

    /**
     * m, the outward unit normal of the contactor's body at x, if known: only
     * points of the curve that face it are taken, m.n < maximal_cosine.
     */
    std::optional<dealii::Tensor<1, 2>> contactor_normal;
    double                              maximal_cosine = -0.1;

    /**
     * Segments that are as if they did not exist: for contact of a boundary
     * with itself those beside the contactor node.
     */
    std::function<bool(const unsigned int)> is_excluded;
  };

  /**
   * The nearest point of a curve, in two stages: a tree of the boxes of the
   * control polygons leaves a few segments, on which all local minima of the
   * distance are found, see find_nearest_places(). The nearest one that the
   * query allows is the answer.
   *
   * A negative gap says that x is inside of the body. It is believed only if
   * the very nearest local minimum, allowed or not, says so, too: so the far
   * side of a thin body never takes a point in front of it for a penetration.
   * A point that is a little inside of a convex corner belongs to the side with
   * the smaller depth, or to the side that faces its normal if that is given;
   * the gap is continuous in x, the normal jumps from one side to the other.
   */
  class CurveSearch
  {
  public:
    /** The curve must outlive this object. */
    explicit CurveSearch(const Curve &curve);

    /** Call it when control points have moved. Cost: n log n. */
    void
    update();

    const Curve &
    curve() const
    {
      return *curve_;
    }

    /** The nearest point of the curve that the query allows, or none. */
    std::optional<CurveProjection>
    project(const dealii::Point<2> &x, const CurveQuery &query = {}) const;

  private:
    struct Candidate
    {
      CurveProjection projection;
      double          distance;
    };

    void
    add_candidates(const unsigned int      segment,
                   const dealii::Point<2> &x,
                   const CurveQuery       &query,
                   std::vector<Candidate> &candidates) const;

    std::vector<Candidate>
    candidates(const dealii::Point<2> &x,
               const CurveQuery       &query,
               const bool              only_nearest) const;

    const Curve *curve_;
    SegmentTree  tree_;
  };
} // namespace Signorini

#endif
