#ifndef signorini_curves_curve_crossing_h
#define signorini_curves_curve_crossing_h

#include <signorini/curves/curve.h>
#include <signorini/curves/segment_tree.h>

#include <optional>
#include <vector>

namespace Signorini
{
  /** Where and when a point passes a curve. */
  struct Crossing
  {
    double         fraction; // of the step, 0 ... 1
    CurveParameter place;
  };

  /**
   * Finds points that pass a curve from outside to inside within a step, also
   * those that are outside again at its end: a gap does not see them.
   *
   * Point and control points move on straight lines with constant speed, so
   * that F(xi, t) = sum_i B_i(xi) ((1 - t) (p_i - x) + t (P_i - X)) is zero at
   * a crossing, with capitals for the end of the step. F lies in the hull of
   * its 8 coefficients: cells of (xi, t) whose coefficients leave no room for
   * zero are dropped, others halved until Newton's method finds their root.
   *
   * A point that only touches the curve does not cross it. One that begins on
   * it and goes inwards does, at fraction 0.
   */
  class CurveCrossing
  {
  public:
    /** Both must have the same segments, and outlive this object. */
    CurveCrossing(const Curve &start, const Curve &end);

    /** A curve at rest. */
    explicit CurveCrossing(const Curve &curve);

    /** The first crossing inwards of the path from x to X. */
    std::optional<Crossing>
    first(const dealii::Point<2> &start, const dealii::Point<2> &end) const;

  private:
    const Curve *start_;
    const Curve *end_;
    SegmentTree  tree_;
  };
} // namespace Signorini

#endif
