#include <signorini/time/step_error.h>

#include <cmath>

namespace Signorini
{
  double
  relative_step_error(const GeneralizedAlpha &scheme,
                      const double            step_size,
                      const double            acceleration_change,
                      const double            largest_speed)
  {
    if (largest_speed == 0.)
      return 0.;
    const double lag = scheme.alpha_H - scheme.alpha_B;
    return std::abs(scheme.beta - 0.5 * lag - 1. / 6.) * step_size *
           acceleration_change / largest_speed;
  }
} // namespace Signorini
