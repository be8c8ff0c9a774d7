#ifndef signorini_time_motion_rates_h
#define signorini_time_motion_rates_h

#include <functional>

namespace Signorini
{
  /** First and second derivative of a motion, in m/s and m/s^2. */
  struct MotionRates
  {
    double velocity     = 0.;
    double acceleration = 0.;
  };

  /**
   * By differences of second order that look back, so that a kink at the end of
   * a step is not yet felt, and a motion that is given for the time of the run
   * only is not asked for more. At the start they look ahead.
   * @param time       s, not negative
   * @param difference between the times at which the motion is asked, s
   */
  MotionRates
  motion_rates(const std::function<double(double)> &motion,
               const double                         time,
               const double                         difference);
} // namespace Signorini

#endif
