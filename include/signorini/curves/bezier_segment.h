#ifndef signorini_curves_bezier_segment_h
#define signorini_curves_bezier_segment_h

#include <deal.II/base/bounding_box.h>
#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <array>

namespace Signorini
{
  /** Bernstein polynomials of degree 3 at xi, or their derivatives. */
  std::array<double, 4>
  bernstein(const double xi);

  std::array<double, 4>
  bernstein_derivative(const double xi);

  /**
   * Cubic curve in Bernstein form, y(xi) = sum_i B_i(xi) p_i, 0 <= xi <= 1,
   * [MC, eq. 30]. It lies in the convex hull of its control points p_i, begins
   * at p_0 in the direction of p_1 and ends at p_3 from the direction of p_2.
   */
  struct BezierSegment
  {
    std::array<dealii::Point<2>, 4> control; // p_i, m

    /** The straight segment, with constant speed. */
    static BezierSegment
    line(const dealii::Point<2> &start, const dealii::Point<2> &end);

    /** y, m. */
    dealii::Point<2>
    value(const double xi) const;

    /** y' = dy/dxi, m. */
    dealii::Tensor<1, 2>
    derivative(const double xi) const;

    /** y'' = d^2 y/dxi^2, m. */
    dealii::Tensor<1, 2>
    second_derivative(const double xi) const;

    /**
     * y'/|y'|. Where y' is zero (control points that coincide at an end), the
     * direction of the chord to the next control point.
     */
    dealii::Tensor<1, 2>
    tangent(const double xi) const;

    /** The box of the control points: it holds the segment. */
    dealii::BoundingBox<2>
    box() const;

    /** Arc length to about 1e-12 of itself, m. */
    double
    length() const;

    /** The pieces before and after xi, each with its own 0 <= xi <= 1. */
    std::pair<BezierSegment, BezierSegment>
    split(const double xi) const;
  };
} // namespace Signorini

#endif
