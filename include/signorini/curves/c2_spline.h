#ifndef signorini_curves_c2_spline_h
#define signorini_curves_c2_spline_h

#include <signorini/curves/curve.h>

#include <array>
#include <optional>
#include <vector>

namespace Signorini
{
  /**
   * The cubic spline through points whose second derivative is continuous. The
   * knots are the chord lengths h, so that the speed dy/dt is about one. The
   * slopes m at the points follow from a tridiagonal system; with the steps h_1
   * before and h_2 after a point and the slopes d of their chords
   *
   *   h_2 m_(i-1) + 2 (h_1 + h_2) m_i + h_1 m_(i+1) = 3 (h_2 d_1 + h_1 d_2).
   *
   * Ends are natural, 2 m_0 + m_1 = 3 d_0 (no curvature), or clamped to a unit
   * tangent; a closed spline is periodic. Where the polygon turns by more than
   * the feature angle the spline is broken into two with natural ends.
   *
   * @param feature_angle degrees; 180 for no corners
   * @param tangents      at start and end of an open spline, in the direction
   * of the walk; none: natural
   * @throws InputError for less than two points (closed: three) or neighbours
   * at the same place.
   */
  Curve
  c2_spline(
    const std::vector<dealii::Point<2>>                      &points,
    const bool                                                is_closed,
    const double                                              feature_angle,
    const std::array<std::optional<dealii::Tensor<1, 2>>, 2> &tangents = {},
    const std::array<CurveEnd, 2>                            &ends     = {});
} // namespace Signorini

#endif
