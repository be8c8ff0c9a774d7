#include <signorini/simulation/energy_balance.h>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    InterfaceForces
    sum(const InterfaceForces &a, const InterfaceForces &b)
    {
      InterfaceForces result(a);
      for (unsigned int k = 0; k < b.normal.size(); ++k)
        {
          result.normal[k] += b.normal[k];
          for (unsigned int j = 0; j < 2; ++j)
            result.tangential[k][j] += b.tangential[k][j];
        }
      return result;
    }

    template <int dim>
    double
    friction_work(const std::vector<ContactPoint<dim>> &points,
                  const InterfaceForces                &mean_forces)
    {
      double work = 0.;
      for (unsigned int k = 0; k < points.size(); ++k)
        for (unsigned int j = 0; j < dim - 1; ++j)
          work += mean_forces.tangential[k][j] * points[k].slip[j];
      return work;
    }
  } // namespace



  void
  measure_kinetic_energy(const SparseMatrix<double> &mass, State &state)
  {
    state.energy.kinetic = 0.5 * mass.matrix_norm_square(state.velocity);
  }



  template <int dim>
  void
  measure_support_forces(const SolidModel<dim>                &solid,
                         const SparseMatrix<double>           *mass,
                         const ContactModel<dim>              &contact,
                         const std::vector<ContactPoint<dim>> &points,
                         State                                &state)
  {
    if (solid.supports_are_fixed())
      return; // their forces do no work
    Vector<double> force(state.internal_force);
    force -= state.external_force;
    Vector<double> product(force.size());
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
    contact.add_contact_forces(points, state.contact_forces, -1., force);
    for (unsigned int i = 0; i < force.size(); ++i)
      state.support_force[i] = solid.is_fixed()[i] ? force[i] : 0.;
  }



  template <int dim>
  void
  measure_work(const SolidModel<dim>                &solid,
               const ContactModel<dim>              &contact,
               const State                          &old_state,
               const std::vector<ContactPoint<dim>> &points,
               State                                &state)
  {
    Vector<double> motion(state.displacement);
    motion -= old_state.displacement;
    EnergyLedger &energy = state.energy;
    energy.loads +=
      0.5 * (motion * old_state.external_force + motion * state.external_force);
    if (!solid.supports_are_fixed())
      energy.supports +=
        0.5 * (motion * old_state.support_force + motion * state.support_force);

    const InterfaceForces twice_mean =
      sum(old_state.contact_forces, state.contact_forces);
    Vector<double> force(motion.size());
    contact.add_contact_forces(points, twice_mean, 0.5, force);
    const double friction = 0.5 * friction_work(points, twice_mean);
    energy.friction += friction;
    energy.contact += motion * force + friction;

    if (solid.is_damped())
      {
        Vector<double> velocity(state.velocity);
        velocity.sadd(0.5, 0.5, old_state.velocity);
        solid.damping().vmult(force, velocity);
        energy.damping += motion * force;
      }
  }



  template void
  measure_support_forces(const SolidModel<2> &,
                         const SparseMatrix<double> *,
                         const ContactModel<2> &,
                         const std::vector<ContactPoint<2>> &,
                         State &);
  template void
  measure_support_forces(const SolidModel<3> &,
                         const SparseMatrix<double> *,
                         const ContactModel<3> &,
                         const std::vector<ContactPoint<3>> &,
                         State &);
  template void
  measure_work(const SolidModel<2> &,
               const ContactModel<2> &,
               const State &,
               const std::vector<ContactPoint<2>> &,
               State &);
  template void
  measure_work(const SolidModel<3> &,
               const ContactModel<3> &,
               const State &,
               const std::vector<ContactPoint<3>> &,
               State &);
} // namespace Signorini
