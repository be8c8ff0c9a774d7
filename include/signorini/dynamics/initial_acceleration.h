#ifndef signorini_dynamics_initial_acceleration_h
#define signorini_dynamics_initial_acceleration_h

#include <signorini/dynamics/contact_system.h>
#include <signorini/dynamics/state.h>

namespace Signorini
{
  /**
   * The accelerations at t = 0+ that balance the loads, M A = F - F_int - C V +
   * contact forces. Nodes without mass move to where they are in balance. The
   * state has displacements, velocities, loads, and the accelerations of
   * prescribed motions; it gets the rest, and the contact forces.
   */
  template <int dim>
  void
  balance_initial_acceleration(
    const SolidModel<dim>                             &solid,
    const typename SolidModel<dim>::RedistributedMass &mass,
    const std::vector<ContactPoint<dim>>              &points,
    ContactSystem<dim>                                &system,
    State                                             &state);
} // namespace Signorini

#endif
