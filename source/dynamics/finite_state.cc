#include <signorini/dynamics/finite_state.h>
#include <signorini/input/input_error.h>
#include <signorini/input/instantiate.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>
#include <utility>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    [[noreturn]] void
    throw_not_finite(const std::string &what,
                     const double       value,
                     const double       time)
    {
      std::ostringstream message;
      message << "At t = " << time << " s " << what << " is "
              << (std::isnan(value) ? "not a number" : "infinite")
              << ". Look for values in the input that are too large or too "
                 "small for their unit; shorter steps may help as well.";
      throw ComputationError(message.str());
    }

    bool
    are_finite(const EnergyLedger &energy)
    {
      // A sum loses neither NaN nor infinity.
      return std::isfinite(energy.scheme_loss());
    }

    bool
    are_finite(const InterfaceForces &forces)
    {
      const auto is_finite = [](const double force) {
        return std::isfinite(force);
      };
      return std::all_of(forces.normal.begin(),
                         forces.normal.end(),
                         is_finite) &&
             std::all_of(forces.tangential.begin(),
                         forces.tangential.end(),
                         [&](const auto &force) {
                           return std::all_of(force.begin(),
                                              force.end(),
                                              is_finite);
                         });
    }
  } // namespace



  template <int dim>
  void
  require_finite(const State &state, const SolidModel<dim> &solid)
  {
    const std::array<std::pair<const char *, const DofVector *>, 5> vectors = {
      {{"the displacement", &state.displacement},
       {"the velocity", &state.velocity},
       {"the acceleration", &state.acceleration},
       {"the internal force", &state.internal_force},
       {"the external force", &state.external_force}}};
    for (const auto &[name, vector] : vectors)
      for (unsigned int i = 0; i < vector->size(); ++i)
        if (!std::isfinite((*vector)[i]))
          throw_not_finite(name + (" of " + solid.unknown_in_words(i)),
                           (*vector)[i],
                           state.time);
    if (!are_finite(state.contact.forces))
      throw_not_finite("a contact force", std::nan(""), state.time);
    for (const double gap : state.contact.gaps) // infinite: out of reach
      if (std::isnan(gap))
        throw_not_finite("a gap", gap, state.time);
    if (!are_finite(state.energy))
      throw_not_finite("the energy", state.energy.scheme_loss(), state.time);
  }



#define INSTANTIATE(dim) \
  template void require_finite(const State &, const SolidModel<dim> &);
  SIGNORINI_FOR_EACH_DIMENSION(INSTANTIATE)
#undef INSTANTIATE
} // namespace Signorini
