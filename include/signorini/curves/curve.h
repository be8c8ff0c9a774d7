#ifndef signorini_curves_curve_h
#define signorini_curves_curve_h

#include <signorini/curves/bezier_segment.h>

#include <array>
#include <vector>

namespace Signorini
{
  /** A place on a curve. */
  struct CurveParameter
  {
    unsigned int segment;
    double       xi; // 0 ... 1
  };

  /** What becomes of the body where an open curve ends. */
  enum class CurveEndKind
  {
    free,      // nothing is known beyond: no contact there
    symmetric, // the curve goes on as its mirror image
    corner     // the body goes on round a corner, without being a target
  };

  struct CurveEnd
  {
    CurveEndKind kind = CurveEndKind::free;

    /**
     * Symmetric ends: the component that changes its sign in the mirror, 0 for
     * a vertical line of symmetry (x = const), 1 for a horizontal one.
     */
    unsigned int mirrored_component = 0;

    /**
     * Corner ends: the outward unit normal of the body's boundary just beyond
     * the end, the other side of the normal cone.
     */
    dealii::Tensor<1, 2> normal;
  };

  /**
   * A chain of cubic Bezier segments, the boundary of a body or a part of it.
   *
   * Orientation: who walks along it with growing parameter has the body, the
   * material of the target, on the *left*. The outward normal is the tangent
   * turned by -90 degrees, n = (t_y, -t_x).
   *
   * Each joint is smooth (both segments have one tangent) or a corner. Corners
   * have a normal cone instead of a normal.
   */
  class Curve
  {
  public:
    Curve() = default;

    /**
     * @param is_corner for each segment whether the joint at its end is a
     * corner; in an open curve the last entry counts for nothing
     */
    Curve(std::vector<BezierSegment>     segments,
          std::vector<bool>              is_corner,
          const bool                     is_closed,
          const std::array<CurveEnd, 2> &ends = {});

    unsigned int
    n_segments() const
    {
      return segments_.size();
    }

    const BezierSegment &
    segment(const unsigned int s) const
    {
      return segments_[s];
    }

    void
    set_segment(const unsigned int s, const BezierSegment &segment)
    {
      segments_[s] = segment;
    }

    bool
    is_closed() const
    {
      return is_closed_;
    }

    /** Start (0) or end (1) of an open curve. */
    const CurveEnd &
    end(const unsigned int which) const
    {
      return ends_[which];
    }

    void
    set_end(const unsigned int which, const CurveEnd &end)
    {
      ends_[which] = end;
    }

    /** The joint at the end of segment s is a corner. */
    bool
    is_corner_after(const unsigned int s) const
    {
      return is_corner_[s];
    }

    /** Segment s has a successor, and which. */
    bool
    has_next(const unsigned int s) const
    {
      return is_closed_ || s + 1 < segments_.size();
    }

    unsigned int
    next(const unsigned int s) const
    {
      return s + 1 < segments_.size() ? s + 1 : 0;
    }

    bool
    has_previous(const unsigned int s) const
    {
      return is_closed_ || s > 0;
    }

    unsigned int
    previous(const unsigned int s) const
    {
      return s > 0 ? s - 1 : segments_.size() - 1;
    }

    dealii::Point<2>
    value(const CurveParameter &place) const
    {
      return segments_[place.segment].value(place.xi);
    }

    /** Unit tangent in the direction of growing parameter. */
    dealii::Tensor<1, 2>
    tangent(const CurveParameter &place) const
    {
      return segments_[place.segment].tangent(place.xi);
    }

    /** Outward unit normal. */
    dealii::Tensor<1, 2>
    normal(const CurveParameter &place) const;

    /** m. */
    double
    length() const;

    /** Area that a closed curve has on its left: negative if clockwise. m^2. */
    double
    enclosed_area() const;

    /** The curve walked the other way: the body changes its side. */
    Curve
    reversed() const;

    /** Every point turned about the origin, then moved: R y + u. */
    Curve
    moved(const dealii::Tensor<2, 2> &rotation,
          const dealii::Tensor<1, 2> &translation) const;

  private:
    std::vector<BezierSegment> segments_;
    std::vector<bool>          is_corner_;
    bool                       is_closed_ = false;
    std::array<CurveEnd, 2>    ends_;
  };

  /** The tangent turned by -90 degrees, (t_y, -t_x). */
  dealii::Tensor<1, 2>
  normal_of_tangent(const dealii::Tensor<1, 2> &tangent);

  /** Its inverse, (-n_y, n_x). */
  dealii::Tensor<1, 2>
  tangent_of_normal(const dealii::Tensor<1, 2> &normal);

  /** Angle by which direction b is turned against a, 0 ... pi. Unit: rad. */
  double
  angle_between(const dealii::Tensor<1, 2> &a, const dealii::Tensor<1, 2> &b);

  /**
   * For each segment: does the curve turn by more than the angle where it ends?
   * @param feature_angle degrees
   */
  std::vector<bool>
  corners_between(const std::vector<BezierSegment> &segments,
                  const bool                        is_closed,
                  const double                      feature_angle);
} // namespace Signorini

#endif
