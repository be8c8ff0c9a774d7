#ifndef signorini_dynamics_slip_h
#define signorini_dynamics_slip_h

#include <signorini/contact/contact_model.h>
#include <signorini/dynamics/state.h>

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

  /** Adds the slip of a step of this size, in s, to the state, with its rate.
   */
  template <int dim>
  void
  measure_slip(const double                          step_size,
               const std::vector<ContactPoint<dim>> &points,
               State                                &state);
} // namespace Signorini

#endif
