#include <signorini/dynamics/initial_acceleration.h>
#include <signorini/dynamics/momentum.h>
#include <signorini/dynamics/step_scheme.h>
#include <signorini/dynamics/time_step.h>
#include <signorini/input/instantiate.h>
#include <signorini/variational_inequality/interface_error.h>

#include <algorithm>
#include <limits>
#include <sstream>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    // Relative to the bodies: surfaces that are as near at the start have no
    // mass from the beginning, those that come near later lose it then.
    constexpr double near_distance = 0.1;

    AlgorithmParameters
    scaled(AlgorithmParameters parameters, const double factor)
    {
      parameters.penalty_stiffness *= factor;
      parameters.tangential_penalty_stiffness *= factor;
      return parameters;
    }

    // Largest extent of all bodies together along a coordinate, m.
    template <int dim>
    double
    extent(const SolidModel<dim> &solid)
    {
      double largest = 0.;
      for (unsigned int c = 0; c < dim; ++c)
        {
          double lowest  = std::numeric_limits<double>::max();
          double highest = std::numeric_limits<double>::lowest();
          for (const auto &part : solid.parts())
            for (const auto &node : part.body->nodes())
              {
                lowest  = std::min(lowest, node.point[c]);
                highest = std::max(highest, node.point[c]);
              }
          largest = std::max(largest, highest - lowest);
        }
      return largest;
    }

    double
    largest_diagonal(const DofMatrix &matrix)
    {
      double largest = 0.;
      for (unsigned int i = 0; i < matrix.m(); ++i)
        largest = std::max(largest, matrix.diag_element(i));
      return largest;
    }

    void
    scale(InterfaceForces &forces, const double factor)
    {
      for (double &normal : forces.normal)
        normal *= factor;
      for (auto &tangential : forces.tangential)
        for (double &component : tangential)
          component *= factor;
    }
  } // namespace



  template <int dim>
  TimeStep<dim>::TimeStep(const SolidModel<dim>   &solid,
                          const ContactModel<dim> &contact,
                          const Settings          &settings,
                          Timings                 &timings)
    : solid_(solid)
    , contact_(contact)
    , settings_(settings)
    , timings_(timings)
    , scheme_(step_scheme(settings.time, false))
    , conserves_energy_(settings.time.dynamic && settings.time.conserves_energy)
    , inertia_(solid,
               contact,
               settings.time.dynamic &&
                 settings.time.contact_mass != ContactMass::consistent)
    , system_(make_contact_system(solid,
                                  contact,
                                  scaled(settings.algorithm,
                                         scheme_.multiplier_factor),
                                  !settings.time.dynamic,
                                  timings))
    , largest_mass_(settings.time.dynamic ? largest_diagonal(solid.mass()) : 0.)
    , largest_stiffness_(largest_diagonal(solid.stiffness()))
    , extent_(extent(solid))
    , has_free_modes_(!settings.time.dynamic &&
                      !solid.free_modes(DofVector(solid.n_dofs())).empty())
    , approach_(0.)
    , failed_step_(0)
    , lacks_mass_(false)
    , section_residual_(timings.add("residual and energy"))
    , section_assembly_(solid.is_linear() ? section_residual_ :
                                            timings.add("assembly"))
    , section_contact_(timings.add("gaps"))
  {}



  template <int dim>
  State
  TimeStep<dim>::initial_state(const DofVector           &displacement,
                               const DofVector           &velocity,
                               const std::vector<double> &history)
  {
    State state;
    state.displacement = displacement;
    state.velocity     = velocity;
    state.acceleration.reinit(solid_.n_dofs());
    state.support_force.reinit(solid_.n_dofs());
    state.contact = contact_.initial_state();
    solid_.apply_supports(0., state.displacement);
    // A static run starts unloaded: its first step brings the loads from zero.
    state.external_force.reinit(solid_.n_dofs());
    state.history      = history;
    const State before = state;
    respond(before, settings_.time.step_size, state);
    if (settings_.time.dynamic)
      {
        state.external_force = solid_.external_force(0., state.displacement);
        solid_.apply_support_rates(0.,
                                   settings_.time.step_size,
                                   state.velocity,
                                   state.acceleration);
        const auto points = evaluate_contact(state, state);
        state.massless_nodes =
          inertia_.near(points, state, near_distance * extent_);
        inertia_.mass(state).redistribution.extrapolate(state.velocity);
        system_->use_mass(inertia_.mass(state).matrix,
                          state.massless_nodes.empty());
        balance_initial_acceleration(
          solid_, inertia_.mass(state), points, *system_, state);
      }
    respond(before, settings_.time.step_size, state);
    if (!settings_.time.dynamic)
      state.external_force = 0.;
    const auto points = evaluate_contact(state, state);
    for (unsigned int k = 0; k < points.size(); ++k)
      state.contact.gaps[k] = points[k].gap;
    contact_.begin_slip(points, state.velocity, state.contact);
    measure_supports(points, state);
    measure_motion(state);
    state.energy.initial = state.energy.kinetic + state.energy.stored +
                           state.energy.plastic - state.energy.heating;
    return state;
  }



  template <int dim>
  State
  TimeStep<dim>::advance(const State &old_state, const Step &step)
  {
    approach_ = 0.;
    mass_given_at_.clear();
    State start  = old_state;
    auto  forces = old_state.contact.forces;
    if (has_free_modes_)
      forces = approach_contact(step.end(), start);
    while (true)
      try
        {
          scheme_           = step_scheme(settings_.time, start.keeps_mass);
          State      state  = start;
          const auto landed = iterate(start, step, forces, state);
          if (landed.empty())
            return state;
          start = inertia_.take_mass(start, landed);
        }
      catch (const StepFailed &)
        {
          // No shorter step helps against a surface that wrinkles.
          if (!lacks_mass_ || !system_->enforces_exactly())
            {
              failed_step_ = step.number;
              throw;
            }
          mass_given_at_ = indefinite_at_;
          start          = inertia_.give_mass(old_state);
        }
  }



  template <int dim>
  std::vector<unsigned int>
  TimeStep<dim>::iterate(const State           &old_state,
                         const Step            &step,
                         const InterfaceForces &first_forces,
                         State                 &state)
  {
    fallbacks_.clear();
    indefinite_at_.clear();
    lacks_mass_ = false;
    residuals_.clear();
    if (settings_.time.dynamic)
      system_->use_mass(inertia_.mass(old_state).matrix,
                        old_state.massless_nodes.empty());
    begin(old_state, step, state);
    const std::string held = contact_.held_penetration(state.configuration());
    if (!held.empty())
      throw ComputationError("Contact: " + held);

    Iterate iterate = {first_forces,
                       old_state.contact.is_slipping,
                       std::numeric_limits<double>::max(),
                       0.};
    scale(iterate.multipliers, scheme_.multiplier_factor);
    while (true)
      {
        update_rates(old_state, step.size, state);
        const auto points = evaluate_contact(state, old_state);
        if (state.n_iterations == 0)
          if (auto nodes = inertia_.approaching(points, old_state, step.size);
              !nodes.empty())
            return nodes;
        const auto acting = acting_contacts(points, old_state, state);
        DofVector  force  = residual(old_state, state);
        if (!acting.empty())
          {
            contact_.add_contact_forces(acting, iterate.multipliers, 1., force);
            contact_.add_contact_forces(points,
                                        iterate.multipliers,
                                        -1.,
                                        force);
          }
        measure_balance(step.size, force, points, iterate.multipliers, state);
        const auto unmet = unmet_criterion(state, points, iterate);
        if (!unmet)
          {
            const auto nodes = inertia_.pressed(iterate.multipliers, old_state);
            if (!nodes.empty())
              return nodes;
            refuse_tunnelling(old_state, iterate, state);
            finish(old_state,
                   step.size,
                   force,
                   points,
                   acting.empty() ? points : acting,
                   iterate,
                   state);
            return {};
          }
        if (!std::isfinite(state.residual) ||
            state.n_iterations >= settings_.time.maximal_iterations)
          throw StepFailed(failure_message(state, *unmet));
        iterate = improve(old_state, step.size, force, points, iterate, state);
        refuse_collapse(old_state, state);
      }
  }



  template <int dim>
  typename TimeStep<dim>::Iterate
  TimeStep<dim>::improve(const State                          &old_state,
                         const double                          step_size,
                         const DofVector                      &residual,
                         const std::vector<ContactPoint<dim>> &points,
                         const Iterate                        &iterate,
                         State                                &state)
  {
    factorise(step_size, state);
    try
      {
        auto correction    = system_->correct(residual,
                                           points,
                                           iterate.multipliers,
                                           old_state.contact);
        state.kkt_residual = correction.kkt_residual;
        if (!correction.fallback_contacts.empty())
          fallbacks_ =
            contact_.candidates_in_words(correction.fallback_contacts);
        ++state.n_iterations;
        InterfaceForces forces = iterate.multipliers;
        const double    share =
          follow(old_state, step_size, correction, forces, state);
        const double change = relative_force_change(step_size,
                                                    state,
                                                    iterate.multipliers,
                                                    correction.multipliers);
        return {std::move(forces),
                std::move(correction.is_slipping),
                change,
                share * correction.motion.linfty_norm()};
      }
    catch (const InterfaceError &error)
      {
        throw StepFailed(
          error.what() +
          (error.contacts().empty() ?
             std::string() :
             " They are: " + contact_.candidates_in_words(error.contacts())));
      }
  }



  template <int dim>
  std::vector<ContactPoint<dim>>
  TimeStep<dim>::evaluate_contact(const State &state,
                                  const State &old_state) const
  {
    const auto timing = timings_.measure(section_contact_);
    return contact_.evaluate(state.configuration(), old_state.configuration());
  }



  template <int dim>
  std::vector<ContactPoint<dim>>
  TimeStep<dim>::acting_contacts(const std::vector<ContactPoint<dim>> &points,
                                 const State &old_state,
                                 const State &state) const
  {
    if (!conserves_energy_ || contact_.is_flat())
      return {};
    const auto timing = timings_.measure(section_contact_);
    DofVector  middle(state.displacement);
    middle.sadd(0.5, 0.5, old_state.displacement);
    auto acting =
      contact_.evaluate({middle, 0.5 * (old_state.time + state.time)},
                        old_state.configuration());
    for (unsigned int k = 0; k < points.size(); ++k)
      if (!acting[k].is_in_reach())
        acting[k] = points[k];
      else
        {
          // Slip is that of the whole step, and friction acts along it.
          acting[k].slip           = points[k].slip;
          acting[k].slip_gradients = points[k].slip_gradients;
        }
    return acting;
  }



  template <int dim>
  InterfaceForces
  TimeStep<dim>::contact_forces(const Iterate &iterate) const
  {
    InterfaceForces forces = iterate.multipliers;
    scale(forces, 1. / scheme_.multiplier_factor);
    return forces;
  }



#define INSTANTIATE(dim) template class TimeStep<dim>;
  SIGNORINI_FOR_EACH_DIMENSION(INSTANTIATE)
#undef INSTANTIATE
} // namespace Signorini
