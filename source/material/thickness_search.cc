#include "thickness_search.h"

#include <signorini/material/material.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Signorini
{
  bool
  ThicknessSearch::is_done(const double stress,
                           const double magnitude,
                           const double stiffness)
  {
    constexpr unsigned int max_tries = 100;
    constexpr double       limit     = 0.5; // of one change of the strain
    if (std::abs(stress) <= 1e-12 * magnitude)
      return true;
    if (++n_tries_ == max_tries || std::isnan(stress))
      throw MaterialFailure(
        "Plane stress: the strain across the thickness was not found in " +
        std::to_string(max_tries) + " iterations; the stress across it is " +
        std::to_string(stress) + " Pa.");

    if (stress < 0.)
      {
        lower_     = strain_;
        has_lower_ = true;
      }
    else
      {
        upper_     = strain_;
        has_upper_ = true;
      }
    double change = stiffness > 0. ? -stress / stiffness :
                    stress < 0.    ? limit :
                                     -limit;
    change        = std::clamp(change, -limit, limit);

    // Rounding may leave more of a stress that is small against what the strain
    // of a finite rotation, or of a plastic flow, is rounded to.
    const bool is_rounding =
      std::abs(change) <=
        std::numeric_limits<double>::epsilon() * (guess_ + std::abs(strain_)) ||
      (n_tries_ > 1 && std::abs(change) < 1e-12 &&
       std::abs(stress) > 0.5 * std::abs(last_stress_));
    if (is_rounding)
      return true;
    if (has_lower_ && has_upper_ &&
        !(strain_ + change > lower_ && strain_ + change < upper_))
      change = 0.5 * (lower_ + upper_) - strain_;

    last_stress_ = stress;
    strain_ += change;
    return false;
  }



  StrainResponse
  respond_in_plane_stress(const StrainLaw               &law,
                          dealii::SymmetricTensor<2, 3> &trial_strain,
                          const double                   step_size,
                          const PlasticState            &state_n)
  {
    const double    guess = trial_strain[2][2];
    ThicknessSearch search(guess);
    while (true)
      {
        trial_strain[2][2] = guess + search.strain();
        const StrainResponse response =
          law.respond(trial_strain, step_size, state_n);
        double stiffness = response.bulk + 4. / 3. * response.shear;
        if (response.flows)
          stiffness += 2. * response.direction[2][2] * response.factor[2][2];
        if (search.is_done(response.stress[2][2],
                           response.stress.norm(),
                           stiffness))
          return response;
      }
  }
} // namespace Signorini
