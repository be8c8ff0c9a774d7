#ifndef signorini_simulation_slip_h
#define signorini_simulation_slip_h

#include <signorini/contact/contact_model.h>
#include <signorini/simulation/state.h>

#include <vector>

namespace Signorini
{
  /** mu of each candidate in the next step, from how it slipped in the last. */
  template <int dim>
  std::vector<double>
  friction_coefficients(const ContactModel<dim> &contact, const State &state);

  /** Marks the closed contacts that the initial velocity makes slip. */
  template <int dim>
  void
  find_initial_slip(const std::vector<ContactPoint<dim>> &points, State &state);

  /**
   * Adds the slip of a step to the state, with its rate, and marks the contacts
   * whose friction is at its bound.
   * @param coefficients mu of each candidate in this step
   */
  template <int dim>
  void
  measure_slip(const ContactModel<dim>              &contact,
               const State                          &old_state,
               const std::vector<ContactPoint<dim>> &points,
               const std::vector<double>            &coefficients,
               State                                &state);
} // namespace Signorini

#endif
