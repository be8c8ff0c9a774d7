#include <signorini/dynamics/contact_work.h>
#include <signorini/dynamics/step_failed.h>
#include <signorini/input/instantiate.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    // Energy sum_c F_c ((P dU)_c - dU_c)/2 that a step makes since a node c
    // lost its mass: the trapezoidal rule lets the force F_c that it had at the
    // start of the step act where its mass is, while it goes another way, dU_c.
    double
    work_of_landing(const MassRedistribution &redistribution,
                    const State              &old_state,
                    const State              &state)
    {
      if (old_state.handed_over.size() == 0)
        return 0.;
      DofVector motion(state.displacement);
      motion -= old_state.displacement;
      DofVector carried(motion);
      redistribution.extrapolate(carried);
      return 0.5 *
             (old_state.handed_over * carried - old_state.handed_over * motion);
    }

    // What did that work: the force F_c on a node and its reaction P^T F_c
    // where its mass went.
    DofVector
    landing_force(const MassRedistribution &redistribution,
                  const State              &old_state,
                  const unsigned int        n_unknowns)
    {
      if (old_state.handed_over.size() == 0)
        return DofVector(n_unknowns);
      DofVector reaction(old_state.handed_over);
      for (unsigned int i = 0; i < n_unknowns; ++i)
        if (redistribution.is_massless(i))
          redistribution.hand_over(i, reaction);
      DofVector force(old_state.handed_over);
      force -= reaction;
      return force;
    }

    // Of all energy that was or is: less is the fluctuation of the scheme from
    // step to step.
    constexpr double largest_returned_gain = 5e-2;

    [[noreturn]] void
    throw_gain(const double gain, const double energy)
    {
      std::ostringstream message;
      message << "contacts that open or close in the step make " << gain
              << " J of " << energy
              << " J: the step is too long for the impact";
      throw StepFailed(message.str());
    }
  } // namespace



  template <int dim>
  void
  return_contact_work(const ContactModel<dim> &contact,
                      const typename SolidModel<dim>::RedistributedMass &mass,
                      const State                          &old_state,
                      const std::vector<ContactPoint<dim>> &points,
                      const StepContact<dim>               &step_contact,
                      ContactSystem<dim>                   &system,
                      State                                &state)
  {
    const double undue = step_contact.undue_work();
    const double debt  = old_state.contact_debt - undue -
                        work_of_landing(mass.redistribution, old_state, state);
    state.contact_debt = debt;

    // Rounding is no work.
    const double energy = old_state.energy.kinetic + old_state.energy.stored;
    if (std::abs(debt) <= 1e-14 * energy)
      return;
    const double lost =
      state.energy.scheme_loss() - old_state.energy.scheme_loss() - undue;

    DofVector force(state.velocity.size());
    contact.add_contact_forces(points, step_contact.normal_forces(), 1., force);
    if (force.all_zero())
      force = landing_force(mass.redistribution, old_state, force.size());
    if (force.all_zero())
      return;
    DofVector direction = system.respond(force);
    mass.redistribution.extrapolate(direction);

    DofVector momentum(direction.size());
    mass.matrix.vmult(momentum, direction);
    const double a            = 0.5 * (direction * momentum);
    const double b            = state.velocity * momentum;
    const double discriminant = b * b + 4. * a * debt;

    // All of it, or what motion along the contact forces has.
    const double returned = discriminant >= 0. ? debt : -0.25 * b * b / a;
    const double s =
      discriminant >= 0. ?
        2. * debt / (b + std::copysign(std::sqrt(discriminant), b)) :
        -0.5 * b / a;
    state.velocity.add(s, direction);
    state.energy.returned += returned;
    state.contact_debt = debt - returned;

    const double gain = returned - lost;
    const double all =
      std::max(energy, state.energy.kinetic + state.energy.stored) +
      old_state.energy.plastic + old_state.energy.damping +
      old_state.energy.friction + std::abs(old_state.energy.scheme_loss());
    if (gain > largest_returned_gain * all)
      throw_gain(gain, all);
  }



#define INSTANTIATE(dim)                        \
  template void return_contact_work(            \
    const ContactModel<dim> &,                  \
    const SolidModel<dim>::RedistributedMass &, \
    const State &,                              \
    const std::vector<ContactPoint<dim>> &,     \
    const StepContact<dim> &,                   \
    ContactSystem<dim> &,                       \
    State &);
  SIGNORINI_FOR_EACH_DIMENSION(INSTANTIATE)
#undef INSTANTIATE
} // namespace Signorini
