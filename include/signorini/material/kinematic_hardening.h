#ifndef signorini_material_kinematic_hardening_h
#define signorini_material_kinematic_hardening_h

#include <signorini/input/entry_condition.h>

namespace dealii
{
  class ParameterHandler;
}

namespace Signorini
{
  /**
   * How the back stress X follows the plastic strain E_p,
   *   dX = 2/3 H_k dE_p - gamma X da,   da = sqrt(2/3) |dE_p|:
   * linear (Prager) with gamma = 0, else after Armstrong and Frederick. In
   * uniaxial tension sqrt(3/2)|X| grows with H_k and ends at H_k/gamma.
   */
  struct KinematicHardening
  {
    double modulus  = 0.; // H_k >= 0, Pa
    double recovery = 0.; // gamma >= 0, 1

    bool
    is_present() const
    {
      return modulus > 0.;
    }

    static void
    declare_parameters(dealii::ParameterHandler &prm);

    /** Which entries are read under which choice. */
    static EntryConditions
    conditions();

    /** @throws InputError. */
    static KinematicHardening
    parse(const dealii::ParameterHandler &prm);
  };
} // namespace Signorini

#endif
