#ifndef signorini_curves_moving_triangle_h
#define signorini_curves_moving_triangle_h

#include <deal.II/base/point.h>

#include <array>

namespace Signorini
{
  /** A triangle whose corners move evenly within a step. Its normal is that of
   * (b - a) x (c - a). */
  struct MovingTriangle
  {
    std::array<dealii::Point<3>, 3> start;
    std::array<dealii::Point<3>, 3> end;
  };

  /**
   * Does a point that moves evenly, too, pass the triangle against its normal,
   * and come deeper below it than @p tolerance, m? The volume spanned by point
   * and triangle is cubic in time; its roots are the instants at which the
   * point is in the plane of the triangle [Provot1997]. That a point arrives
   * there at the end of the step does not count.
   */
  bool
  passes(const dealii::Point<3> &start,
         const dealii::Point<3> &end,
         const MovingTriangle   &triangle,
         const double            tolerance);
} // namespace Signorini

#endif
