#ifndef signorini_time_step_error_h
#define signorini_time_step_error_h

#include <signorini/time/generalized_alpha.h>

namespace Signorini
{
  /**
   * Estimate of the error that a step makes in the displacement, over the way
   * that the largest speed so far makes in it,
   *
   *   e = c dt |A_np - A_n| / |V|_max,
   *   c = |beta - (alpha_H - alpha_B)/2 - 1/6|,
   *
   * with norms of one kind, e.g. that of the mass matrix. The accelerations of
   * generalized-alpha belong to times that lag (alpha_H - alpha_B) dt behind;
   * without weights c is that of [ZienkiewiczXie1991], who divide by the
   * largest displacement. With the way of the step e is of second order, and
   * the errors of all steps together are e times the way of the run at most.
   *
   * @param acceleration_change |A_np - A_n|, m/s^2
   * @param largest_speed       |V|_max, m/s; if nothing moves yet e = 0
   */
  double
  relative_step_error(const GeneralizedAlpha &scheme,
                      const double            step_size,
                      const double            acceleration_change,
                      const double            largest_speed);
} // namespace Signorini

#endif
