#ifndef signorini_simulation_energy_balance_h
#define signorini_simulation_energy_balance_h

#include <signorini/contact/contact_model.h>
#include <signorini/simulation/effective_system.h>
#include <signorini/simulation/state.h>
#include <signorini/solid/solid_model.h>

namespace Signorini
{
  /**
   * Kinetic energy 1/2 V.M V of a state. A static run has no mass, and no
   * kinetic energy.
   */
  template <int dim>
  void
  measure_kinetic_energy(const SolidModel<dim> &solid, State &state);

  /** Forces on the unknowns with given motion, that make it happen. N. */
  template <int dim>
  void
  measure_support_forces(const SolidModel<dim>                &solid,
                         const ContactModel<dim>              &contact,
                         const std::vector<ContactPoint<dim>> &points,
                         State                                &state);

  /**
   * Adds to the ledger the works of a step, each by the trapezoidal rule: mean
   * force times motion. Friction takes sum_k (tau_n + tau_np)/2 . slip_k.
   */
  template <int dim>
  void
  measure_work(const SolidModel<dim>                &solid,
               const ContactModel<dim>              &contact,
               const State                          &old_state,
               const std::vector<ContactPoint<dim>> &points,
               State                                &state);

  /**
   * Gives back the work sum_k (lambda_n + lambda_np)/2 (g_np - g_n), which is
   * zero in the continuous problem but not in a step in which a contact opens
   * or closes: the velocity gets s d with d = K^-1 A^T (lambda_n + lambda_np)
   * the motion that the contact forces would cause, and s the root of smaller
   * size of
   *
   *   1/2 s^2 d.M d + s d.M V = work to be returned.
   *
   * What no real s can return stays as debt for later steps. Gaps and contact
   * forces are untouched. (Cf. Laursen & Love 2002.)
   */
  template <int dim>
  void
  return_contact_work(const SolidModel<dim>                &solid,
                      const ContactModel<dim>              &contact,
                      const State                          &old_state,
                      const std::vector<ContactPoint<dim>> &points,
                      EffectiveSystem<dim>                 &system,
                      State                                &state);
} // namespace Signorini

#endif
