#ifndef signorini_dynamics_energy_balance_h
#define signorini_dynamics_energy_balance_h

#include <signorini/contact/contact_model.h>
#include <signorini/dynamics/state.h>
#include <signorini/dynamics/step_contact.h>
#include <signorini/linear_algebra/types.h>
#include <signorini/solid/solid_model.h>


namespace Signorini
{
  /** Kinetic energy 1/2 V.M V of a state. */
  void
  measure_kinetic_energy(const DofMatrix &mass, State &state);

  /** Forces on the unknowns with given motion, that make it happen. N. A static
   * step has no @p mass: null. */
  template <int dim>
  void
  measure_support_forces(const SolidModel<dim>                &solid,
                         const DofMatrix                      *mass,
                         const ContactModel<dim>              &contact,
                         const std::vector<ContactPoint<dim>> &points,
                         State                                &state);

  /**
   * Adds to the ledger the works of a step: mean force times motion.
   * @param support_force mean of the step, of given unknowns, N
   */
  template <int dim>
  void
  measure_work(const SolidModel<dim>  &solid,
               const StepContact<dim> &contact,
               const DofVector        &support_force,
               const State            &old_state,
               State                  &state);
} // namespace Signorini

#endif
