// The part of TimeStep that ends a step: rates, forces and works.
#include <signorini/dynamics/contact_work.h>
#include <signorini/dynamics/energy_balance.h>
#include <signorini/dynamics/momentum.h>
#include <signorini/dynamics/step_contact.h>
#include <signorini/dynamics/time_step.h>
#include <signorini/input/instantiate.h>
#include <signorini/linear_algebra/types.h>

#include <algorithm>

namespace Signorini
{
  using namespace dealii;

  template <int dim>
  void
  TimeStep<dim>::finish(const State                          &old_state,
                        const double                          step_size,
                        const DofVector                      &residual,
                        const std::vector<ContactPoint<dim>> &points,
                        const std::vector<ContactPoint<dim>> &acting,
                        const Iterate                        &iterate,
                        State                                &state)
  {
    state.contact.forces      = contact_forces(iterate);
    state.contact.is_slipping = iterate.is_slipping;
    contact_.advance(step_size, points, state.contact);
    refuse_fast_wear(points, state);
    if (conserves_energy_)
      set_mean_acceleration(old_state, step_size, state);
    if (settings_.time.dynamic)
      {
        const auto &mass = inertia_.mass(state);
        mass.redistribution.extrapolate(state.velocity);
        mass.redistribution.extrapolate(state.acceleration);
      }
    const auto timing = timings_.measure(section_residual_);
    measure_supports(points, state);
    measure_motion(state);
    const auto &old_forces = old_state.contact.forces.normal;
    const bool  has_old_forces =
      std::any_of(old_forces.begin(), old_forces.end(), [](const double force) {
        return force != 0.;
      });
    const StepContact<dim> contact(contact_,
                                   old_state,
                                   scheme_.old_contact_share > 0. &&
                                       has_old_forces ?
                                     evaluate_contact(old_state, old_state) :
                                     acting,
                                   state,
                                   acting,
                                   scheme_.old_contact_share);
    measure_work(solid_,
                 contact,
                 mean_support_force(old_state, residual, points, state),
                 old_state,
                 state);
    if (settings_.time.dynamic && settings_.time.return_contact_work &&
        system_->enforces_exactly())
      {
        return_contact_work(contact_,
                            inertia_.mass(state),
                            old_state,
                            points,
                            contact,
                            *system_,
                            state);
        measure_motion(state);
      }
    if (solid_.mass().empty())
      {
        state.velocity = state.displacement;
        state.velocity -= old_state.displacement;
        state.velocity /= step_size;
      }
    state.handed_over.reinit(0);
  }



  // What wears in a step opens the gap in the next. That is stable where it is
  // less than what the force presses a node in by, with its neighbours held.
  template <int dim>
  void
  TimeStep<dim>::refuse_fast_wear(const std::vector<ContactPoint<dim>> &points,
                                  const State &state) const
  {
    constexpr double          largest_share = 0.5;
    const std::vector<double> gains =
      contact_.recession_gains(points, state.contact);
    std::vector<unsigned int> fast;
    for (unsigned int k = 0; k < gains.size(); ++k)
      {
        if (gains[k] <= 0.)
          continue;
        double compliance = 0.; // m/N
        for (const auto &[i, a] : points[k].gap_gradient)
          if (solid_.stiffness().diag_element(i) > 0.)
            compliance += a * a / solid_.stiffness().diag_element(i);
        const double pressed_in = state.contact.forces.normal[k] * compliance;
        if (gains[k] > largest_share * pressed_in)
          fast.push_back(k);
      }
    if (!fast.empty())
      throw StepFailed("in the step contacts wear deeper than half of what "
                       "their forces press them in by: " +
                       contact_.candidates_in_words(fast));
  }



  template <int dim>
  void
  TimeStep<dim>::set_mean_acceleration(const State &old_state,
                                       const double step_size,
                                       State       &state) const
  {
    // At the end of a step nothing else is known of it: what Newmark's formula
    // gives there swings around it from step to step.
    for (unsigned int i = 0; i < solid_.n_dofs(); ++i)
      if (!solid_.dof_map().is_prescribed(i))
        state.acceleration[i] =
          (state.velocity[i] - old_state.velocity[i]) / step_size;
  }



  template <int dim>
  DofVector
  TimeStep<dim>::mean_support_force(
    const State                          &old_state,
    const DofVector                      &residual,
    const std::vector<ContactPoint<dim>> &points,
    const State                          &state) const
  {
    DofVector mean(state.support_force);
    mean.sadd(0.5, 0.5, old_state.support_force);
    if (!conserves_energy_ || solid_.supports_are_fixed())
      return mean;
    // What the balance of the step lacks.
    DofVector lacking(residual);
    contact_.add_contact_forces(points, state.contact.forces, 1., lacking);
    for (unsigned int i = 0; i < mean.size(); ++i)
      mean[i] = solid_.dof_map().is_constrained(i) ? -lacking[i] : 0.;
    return mean;
  }



  template <int dim>
  void
  TimeStep<dim>::measure_supports(const std::vector<ContactPoint<dim>> &points,
                                  State                                &state)
  {
    measure_support_forces(solid_,
                           solid_.mass().empty() ? nullptr :
                                                   &inertia_.mass(state).matrix,
                           contact_,
                           points,
                           state);
  }



  template <int dim>
  void
  TimeStep<dim>::measure_motion(State &state)
  {
    if (solid_.mass().empty())
      return;
    const DofMatrix &mass = inertia_.mass(state).matrix;
    measure_kinetic_energy(mass, state);
    state.motions = body_motions(solid_, mass, state);
  }



#define INSTANTIATE(dim)                                                      \
  template void TimeStep<dim>::finish(const State &,                          \
                                      const double,                           \
                                      const DofVector &,                      \
                                      const std::vector<ContactPoint<dim>> &, \
                                      const std::vector<ContactPoint<dim>> &, \
                                      const Iterate &,                        \
                                      State &);                               \
  template void TimeStep<dim>::measure_supports(                              \
    const std::vector<ContactPoint<dim>> &, State &);                         \
  template void TimeStep<dim>::measure_motion(State &);
  SIGNORINI_FOR_EACH_DIMENSION(INSTANTIATE)
#undef INSTANTIATE
} // namespace Signorini
