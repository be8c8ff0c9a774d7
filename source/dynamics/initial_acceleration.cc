#include <signorini/dynamics/initial_acceleration.h>
#include <signorini/input/instantiate.h>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    // Of the oscillations of single nodes; the true one is less than twice it.
    template <int dim>
    double
    largest_frequency(const SolidModel<dim> &solid)
    {
      double square = 0.;
      for (unsigned int i = 0; i < solid.n_dofs(); ++i)
        if (!solid.dof_map().is_constrained(i) &&
            solid.mass().diag_element(i) > 0.)
          square = std::max(square,
                            solid.stiffness().diag_element(i) /
                              solid.mass().diag_element(i));
      return std::sqrt(square);
    }
  } // namespace



  template <int dim>
  void
  balance_initial_acceleration(
    const SolidModel<dim>                             &solid,
    const typename SolidModel<dim>::RedistributedMass &mass,
    const std::vector<ContactPoint<dim>>              &points,
    ContactSystem<dim>                                &system,
    State                                             &state)
  {
    // The motion in a time tau that is short against every oscillation of the
    // mesh: nodes with mass move by A tau^2, those without to their balance.
    const double tau    = 1e-4 / largest_frequency(solid);
    const double factor = 1. / (tau * tau);
    system.factorise({1., factor, 0.});

    DofVector force(state.external_force);
    force -= state.internal_force;
    DofVector product(force.size());
    mass.matrix.vmult(product, state.acceleration); // of given motions
    force -= product;
    if (solid.is_damped())
      {
        solid.damping().vmult(product, state.velocity);
        force -= product;
      }
    const auto correction =
      system.correct(force, points, state.contact.forces, state.contact);
    state.contact.forces = correction.multipliers;
    for (unsigned int i = 0; i < correction.motion.size(); ++i)
      if (mass.redistribution.is_massless(i))
        state.displacement[i] += correction.motion[i];
      else
        state.acceleration[i] += factor * correction.motion[i];
    solid.dof_map().constraints().distribute(state.displacement);
    solid.dof_map().constraints().distribute(state.acceleration);
    mass.redistribution.extrapolate(state.acceleration);
  }



#define INSTANTIATE(dim)                        \
  template void balance_initial_acceleration(   \
    const SolidModel<dim> &,                    \
    const SolidModel<dim>::RedistributedMass &, \
    const std::vector<ContactPoint<dim>> &,     \
                                                \
    ContactSystem<dim> &,                       \
    State &);
  SIGNORINI_FOR_EACH_DIMENSION(INSTANTIATE)
#undef INSTANTIATE
} // namespace Signorini
