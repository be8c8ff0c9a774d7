#include <signorini/time/motion_rates.h>

namespace Signorini
{
  MotionRates
  motion_rates(const std::function<double(double)> &motion,
               const double                         time,
               const double                         difference)
  {
    const double h      = time < 3. * difference ? -difference : difference;
    const double now    = motion(time);
    const double first  = motion(time - h);
    const double second = motion(time - 2. * h);
    const double third  = motion(time - 3. * h);
    return {(3. * now - 4. * first + second) / (2. * h),
            (2. * now - 5. * first + 4. * second - third) / (h * h)};
  }
} // namespace Signorini
