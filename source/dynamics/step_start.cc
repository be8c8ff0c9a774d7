// The part of TimeStep that begins a step, and takes corrections no further
// than the bodies can follow.
#include <signorini/dynamics/rigid_mechanism.h>
#include <signorini/dynamics/time_step.h>
#include <signorini/input/instantiate.h>
#include <signorini/linear_algebra/types.h>

#include <algorithm>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    // old += share (new - old).
    void
    blend(const InterfaceForces &new_forces,
          const double           share,
          InterfaceForces       &old_forces)
    {
      for (unsigned int k = 0; k < old_forces.normal.size(); ++k)
        {
          old_forces.normal[k] +=
            share * (new_forces.normal[k] - old_forces.normal[k]);
          for (unsigned int j = 0; j < 2; ++j)
            old_forces.tangential[k][j] +=
              share *
              (new_forces.tangential[k][j] - old_forces.tangential[k][j]);
        }
    }
  } // namespace



  template <int dim>
  InterfaceForces
  TimeStep<dim>::approach_contact(const double time, State &start)
  {
    const auto timing = timings_.measure(section_contact_);
    DofVector  displacement(start.displacement);
    solid_.apply_supports(time, displacement);
    std::vector<DofVector> modes;
    for (auto &mode : solid_.free_modes(displacement))
      modes.push_back(std::move(mode.motion));
    const RigidMechanism<dim> mechanism(
      contact_, modes, solid_.external_force(time, displacement));
    const auto approach =
      mechanism.approach({displacement, time, &start.contact});
    if (!approach.is_balanced)
      return start.contact.forces;
    const auto &old_forces = start.contact.forces.normal;
    const bool  is_held =
      std::any_of(old_forces.begin(), old_forces.end(), [](const double force) {
        return force > 0.;
      });
    approach_ = approach.way.linfty_norm();
    if (approach_ == 0.)
      return is_held ? start.contact.forces : approach.forces;
    start.displacement += approach.way;
    const auto points = contact_.evaluate(start.configuration());
    for (unsigned int k = 0; k < points.size(); ++k)
      start.contact.gaps[k] = points[k].gap;
    return approach.forces;
  }



  template <int dim>
  void
  TimeStep<dim>::begin(const State &old_state, const Step &step, State &state)
  {
    state.step         = step.number;
    state.time         = step.end();
    state.n_iterations = 0;
    largest_displacement_.reinit(state.displacement.size());
    for (unsigned int i = 0; i < state.displacement.size(); ++i)
      largest_displacement_[i] = std::abs(state.displacement[i]);
    state.external_force =
      solid_.external_force(state.time, state.displacement);
    if (!solid_.is_linear() && !predict(old_state, step, state) &&
        !has_tangent_of(old_state))
      respond(old_state, step.size, state);
    if (!solid_.supports_are_fixed())
      move_supports(old_state, step.size, state);
  }



  template <int dim>
  bool
  TimeStep<dim>::predict(const State &old_state, const Step &step, State &state)
  {
    // What failed from here once begins where the bodies are.
    if (failed_step_ == step.number || old_state.velocity.all_zero())
      return false;
    // In dynamics inertia does not let them leave their way. Only what turns
    // freely is better off where it will be: the next iterations are not exact.
    const auto &forces   = old_state.contact.forces.normal;
    const bool  is_apart = std::all_of(forces.begin(),
                                      forces.end(),
                                      [](const double f) { return f == 0.; });
    if (settings_.time.dynamic && !(conserves_energy_ && is_apart))
      return false;
    state.displacement.add(step.size, old_state.velocity);
    if (settings_.time.dynamic)
      state.displacement.add(0.5 * step.size * step.size,
                             old_state.acceleration);
    try
      {
        respond(old_state, step.size, state);
        return true;
      }
    catch (const StepFailed &)
      {
        state.displacement = old_state.displacement;
        return false;
      }
  }



  // Where cells go to and fro between elastic and plastic, so does the
  // residual, without becoming smaller; going half the way, and less, ends
  // that.
  template <int dim>
  double
  TimeStep<dim>::first_share() const
  {
    if (solid_.is_linear())
      return 1.;
    constexpr double   stands   = 0.8; // of the residual two iterations ago
    constexpr double   smallest = 1. / 8.;
    const unsigned int n        = residuals_.size();
    double             share    = 1.;
    for (unsigned int last = n; last > 4 && share > smallest; last -= 2)
      {
        if (!(residuals_[last - 1] > stands * residuals_[last - 3]))
          break;
        share *= 0.5;
      }
    return share;
  }



  template <int dim>
  double
  TimeStep<dim>::follow(const State             &old_state,
                        const double             step_size,
                        const ContactCorrection &correction,
                        InterfaceForces         &forces,
                        State                   &state)
  {
    constexpr double smallest = 1. / 64.;
    const DofVector  start(state.displacement);
    double           share = first_share();
    while (true)
      try
        {
          state.displacement = start;
          state.displacement.add(share, correction.motion);
          respond(old_state, step_size, state);
          blend(correction.multipliers, share, forces);
          return share;
        }
      catch (const StepFailed &)
        {
          share *= 0.5;
          if (share < smallest)
            throw;
        }
  }



#define INSTANTIATE(dim)                                                        \
  template InterfaceForces TimeStep<dim>::approach_contact(const double,        \
                                                           State &);            \
  template void   TimeStep<dim>::begin(const State &, const Step &, State &);   \
  template bool   TimeStep<dim>::predict(const State &, const Step &, State &); \
  template double TimeStep<dim>::first_share() const;                           \
  template double TimeStep<dim>::follow(const State &,                          \
                                        const double,                           \
                                        const ContactCorrection &,              \
                                        InterfaceForces &,                      \
                                        State &);
  SIGNORINI_FOR_EACH_DIMENSION(INSTANTIATE)
#undef INSTANTIATE
} // namespace Signorini
