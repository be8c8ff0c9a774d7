#include <signorini/dynamics/energy_balance.h>
#include <signorini/input/instantiate.h>

namespace Signorini
{
  using namespace dealii;

  void
  measure_kinetic_energy(const DofMatrix &mass, State &state)
  {
    state.energy.kinetic = 0.5 * mass.matrix_norm_square(state.velocity);
  }



  template <int dim>
  void
  measure_support_forces(const SolidModel<dim>                &solid,
                         const DofMatrix                      *mass,
                         const ContactModel<dim>              &contact,
                         const std::vector<ContactPoint<dim>> &points,
                         State                                &state)
  {
    if (solid.supports_are_fixed())
      return; // their forces do no work
    DofVector force(state.internal_force);
    force -= state.external_force;
    DofVector product(force.size());
    if (mass)
      {
        mass->vmult(product, state.acceleration);
        force += product;
      }
    if (solid.is_damped())
      {
        solid.damping().vmult(product, state.velocity);
        force += product;
      }
    contact.add_contact_forces(points, state.contact.forces, -1., force);
    for (unsigned int i = 0; i < force.size(); ++i)
      state.support_force[i] =
        solid.dof_map().is_constrained(i) ? force[i] : 0.;
  }



  template <int dim>
  void
  measure_work(const SolidModel<dim>  &solid,
               const StepContact<dim> &contact,
               const DofVector        &support_force,
               const State            &old_state,
               State                  &state)
  {
    DofVector motion(state.displacement);
    motion -= old_state.displacement;
    EnergyLedger &energy = state.energy;
    energy.loads +=
      0.5 * (motion * old_state.external_force + motion * state.external_force);
    if (!solid.supports_are_fixed())
      energy.supports += motion * support_force;

    energy.friction += contact.friction();
    energy.wear += contact.wear();
    energy.contact +=
      contact.work() - contact.tangential_work() + contact.wear();

    if (solid.is_damped())
      {
        DofVector velocity(state.velocity), force(motion.size());
        velocity.sadd(0.5, 0.5, old_state.velocity);
        solid.damping().vmult(force, velocity);
        energy.damping += motion * force;
      }
  }



#define INSTANTIATE(dim)                                                       \
  template void measure_support_forces(const SolidModel<dim> &,                \
                                       const DofMatrix *,                      \
                                       const ContactModel<dim> &,              \
                                       const std::vector<ContactPoint<dim>> &, \
                                       State &);                               \
  template void measure_work(const SolidModel<dim> &,                          \
                             const StepContact<dim> &,                         \
                             const DofVector &,                                \
                             const State &,                                    \
                             State &);
  SIGNORINI_FOR_EACH_DIMENSION(INSTANTIATE)
#undef INSTANTIATE
} // namespace Signorini
