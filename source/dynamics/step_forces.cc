// The part of TimeStep that asks the bodies for their forces.
#include <signorini/dynamics/time_step.h>
#include <signorini/input/instantiate.h>
#include <signorini/linear_algebra/sparse_cholesky.h>
#include <signorini/linear_algebra/types.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Signorini
{
  using namespace dealii;

  template <int dim>
  SystemFactors
  TimeStep<dim>::effective_factors(const double step_size) const
  {
    if (!settings_.time.dynamic)
      return {1., 0., 0.};
    const auto inertia = [&](const GeneralizedAlpha &scheme) {
      return (1. - scheme.alpha_B) * scheme.acceleration_factor(step_size);
    };
    return {1. - scheme_.bodies.alpha_H,
            inertia(scheme_.bodies),
            solid_.is_damped() ? (1. - scheme_.bodies.alpha_H) *
                                   scheme_.bodies.velocity_factor(step_size) :
                                 0.,
            inertia(scheme_.rigid_bodies) / inertia(scheme_.bodies) /
              scheme_.rigid_share};
  }



  template <int dim>
  void
  TimeStep<dim>::respond(const State &old_state,
                         const double step_size,
                         State       &state)
  {
    const auto timing = timings_.measure(
      solid_.is_linear() ? section_residual_ : section_assembly_);
    tangent_displacement_.reinit(0); // until the tangent is whole
    // A static run begins as if nothing acted yet: neither loads nor heat.
    std::optional<double> temperature_time;
    if (settings_.time.dynamic || state.step > 0)
      temperature_time = state.time;
    try
      {
        SolidResponse response =
          solid_.respond({state.displacement,
                          step_size,
                          conserves_energy_ ? &old_state.displacement : nullptr,
                          temperature_time},
                         old_state.history,
                         solid_.is_linear() ? nullptr : &tangent_);
        if (!solid_.is_linear())
          tangent_displacement_ = state.displacement;
        state.internal_force = std::move(response.internal_force);
        mean_internal_force_ = std::move(response.mean_force);
        state.history        = std::move(response.history);
        state.energy.stored  = response.stored_energy;
        state.energy.plastic = response.plastic_work;
        state.energy.heating = response.heating;
        if (solid_.loads_follow())
          state.external_force =
            solid_.external_force(state.time, state.displacement);
      }
    catch (const MaterialFailure &failure)
      {
        throw StepFailed(failure.what());
      }
  }



  template <int dim>
  bool
  TimeStep<dim>::has_tangent_of(const State &state) const
  {
    return state.history.empty() && !conserves_energy_ &&
           tangent_displacement_.size() == state.displacement.size() &&
           tangent_displacement_ == state.displacement;
  }



  template <int dim>
  void
  TimeStep<dim>::move_supports(const State &old_state,
                               const double step_size,
                               State       &state)
  {
    DofVector motion(state.displacement);
    solid_.apply_supports(state.time, state.displacement);
    if (solid_.is_linear())
      {
        respond(old_state, step_size, state);
        return;
      }
    // The forces of this motion to first order: the first correction then
    // spreads it over the bodies, instead of crushing the outer cells.
    motion -= state.displacement;
    DofVector force(motion.size());
    tangent_.vmult(force, motion);
    state.internal_force -= force;
    if (conserves_energy_)
      mean_internal_force_.add(-0.5, force);
  }



  template <int dim>
  void
  TimeStep<dim>::factorise(const double step_size, const State &state)
  {
    const auto factors = effective_factors(step_size);
    if (solid_.is_linear())
      {
        system_->factorise(factors);
        return;
      }
    try
      {
        system_->factorise(factors, &tangent_);
        if (has_free_modes_)
          system_->place(state.displacement);
        if (system_->is_indefinite())
          note_indefinite(system_->indefinite_unknown(), state);
      }
    catch (const NotPositiveDefinite &error)
      {
        note_indefinite(error.unknown, state);
        throw StepFailed(
          "the effective stiffness is not positive definite at " +
          indefinite_at_);
      }
  }



  template <int dim>
  void
  TimeStep<dim>::note_indefinite(const unsigned int unknown, const State &state)
  {
    indefinite_at_ = solid_.unknown_in_words(unknown);
    lacks_mass_ =
      lacks_mass_ || (settings_.time.dynamic &&
                      inertia_.mass(state).redistribution.is_massless(unknown));
  }



  template <int dim>
  void
  TimeStep<dim>::update_rates(const State &old_state,
                              const double step_size,
                              State       &state) const
  {
    if (!settings_.time.dynamic)
      return;
    const auto timing  = timings_.measure(section_residual_);
    state.acceleration = scheme_.bodies.acceleration(state.displacement,
                                                     old_state.displacement,
                                                     old_state.velocity,
                                                     old_state.acceleration,
                                                     step_size);
    state.velocity     = scheme_.bodies.velocity(state.acceleration,
                                             old_state.velocity,
                                             old_state.acceleration,
                                             step_size);
    update_rigid_rates(old_state, step_size, state);
    solid_.apply_support_rates(state.time,
                               step_size,
                               state.velocity,
                               state.acceleration);
  }



  template <int dim>
  DofVector
  TimeStep<dim>::residual(const State &old_state, const State &state)
  {
    const auto timing = timings_.measure(section_residual_);
    DofVector  force(state.external_force);
    force -= state.internal_force;
    if (!settings_.time.dynamic)
      return force;

    // (1-alpha_H) (F - F_int) + alpha_H (F_n - F_int,n); nodes without mass
    // are in balance at the end of the step, whatever was before.
    force *= 1. - scheme_.bodies.alpha_H;
    if (conserves_energy_)
      {
        force = state.external_force;
        force.sadd(0.5, 0.5, old_state.external_force);
        force -= mean_internal_force_;
      }
    else if (scheme_.bodies.alpha_H != 0.)
      {
        DofVector history(old_state.external_force);
        history -= old_state.internal_force;
        inertia_.mass(state).redistribution.clear_massless(history);
        force.add(scheme_.bodies.alpha_H, history);
      }

    DofVector weighted(state.acceleration);
    weighted.sadd(1. - scheme_.bodies.alpha_B,
                  scheme_.bodies.alpha_B,
                  old_state.acceleration);
    DofVector product(force.size());
    inertia_.mass(state).matrix.vmult(product, weighted);
    force -= product;
    if (solid_.is_damped())
      {
        weighted = state.velocity;
        weighted.sadd(1. - scheme_.bodies.alpha_H,
                      scheme_.bodies.alpha_H,
                      old_state.velocity);
        solid_.damping().vmult(product, weighted);
        force -= product;
      }

    set_rigid_residual(old_state, state, force);
    return force;
  }



  template <int dim>
  void
  TimeStep<dim>::update_rigid_rates(const State &old_state,
                                    const double step_size,
                                    State       &state) const
  {
    for (unsigned int i = solid_.dof_map().n_body_dofs(); i < solid_.n_dofs();
         ++i)
      {
        const double factor =
          scheme_.rigid_bodies.acceleration_factor(step_size);
        const double old_rate = old_state.acceleration[i];
        state.acceleration[i] =
          factor * (state.displacement[i] - old_state.displacement[i] -
                    step_size * old_state.velocity[i]) +
          (1. - 0.5 / scheme_.rigid_bodies.beta) * old_rate;
        state.velocity[i] =
          old_state.velocity[i] +
          step_size * ((1. - scheme_.rigid_bodies.gamma) * old_rate +
                       scheme_.rigid_bodies.gamma * state.acceleration[i]);
      }
  }



  template <int dim>
  void
  TimeStep<dim>::set_rigid_residual(const State &old_state,
                                    const State &state,
                                    DofVector   &residual) const
  {
    const double alpha_B = scheme_.rigid_bodies.alpha_B;
    const double alpha_H = scheme_.rigid_bodies.alpha_H;
    for (unsigned int i = solid_.dof_map().n_body_dofs(); i < solid_.n_dofs();
         ++i)
      residual[i] = ((1. - alpha_H) * state.external_force[i] +
                     alpha_H * old_state.external_force[i] -
                     solid_.mass().diag_element(i) *
                       ((1. - alpha_B) * state.acceleration[i] +
                        alpha_B * old_state.acceleration[i])) /
                    scheme_.rigid_share;
  }



#define INSTANTIATE(dim)                                                       \
  template SystemFactors TimeStep<dim>::effective_factors(const double) const; \
  template void TimeStep<dim>::respond(const State &, const double, State &);  \
  template bool TimeStep<dim>::has_tangent_of(const State &) const;            \
  template void TimeStep<dim>::move_supports(const State &,                    \
                                             const double,                     \
                                             State &);                         \
  template void TimeStep<dim>::factorise(const double, const State &);         \
  template void TimeStep<dim>::note_indefinite(const unsigned int,             \
                                               const State &);                 \
  template void TimeStep<dim>::update_rates(const State &,                     \
                                            const double,                      \
                                            State &) const;                    \
  template void TimeStep<dim>::update_rigid_rates(const State &,               \
                                                  const double,                \
                                                  State &) const;              \
  template void TimeStep<dim>::set_rigid_residual(const State &,               \
                                                  const State &,               \
                                                  DofVector &) const;          \
  template DofVector TimeStep<dim>::residual(const State &, const State &);
  SIGNORINI_FOR_EACH_DIMENSION(INSTANTIATE)
#undef INSTANTIATE
} // namespace Signorini
