#include <signorini/dynamics/step_scheme.h>

#include <algorithm>

namespace Signorini
{
  namespace
  {
    // Every node has mass, contact is fully implicit.
    StepScheme
    with_mass(const GeneralizedAlpha &scheme)
    {
      const double old_share =
        std::clamp((1. - scheme.gamma - scheme.alpha_B) / (1. - scheme.alpha_B),
                   0.,
                   0.5);
      return {scheme, scheme, 1., 1., old_share};
    }
  } // namespace



  StepScheme
  step_scheme(const TimeParameters &time, const bool keeps_mass)
  {
    if (!time.dynamic)
      return {time.scheme, time.scheme, 1., 1., 0.5};
    if (time.contact_mass == ContactMass::consistent)
      return with_mass(time.scheme);
    if (keeps_mass)
      return with_mass(time.scheme_with_mass);
    const double factor = 1. - time.scheme.alpha_H;
    return {time.scheme, chung_hulbert(0.), factor, 1. / factor, 0.5};
  }
} // namespace Signorini
