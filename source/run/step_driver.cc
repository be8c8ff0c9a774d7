#include <signorini/dynamics/energy_balance.h>
#include <signorini/input/input_error.h>
#include <signorini/input/instantiate.h>
#include <signorini/linear_algebra/sparse_cholesky.h>
#include <signorini/output/run_folder.h>
#include <signorini/run/energy_verdict.h>
#include <signorini/run/step_driver.h>
#include <signorini/time/step_error.h>
#include <signorini/time/step_plan.h>

#include <algorithm>
#include <fstream>
#include <iomanip>
#include <sstream>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    template <int dim>
    typename TimeStep<dim>::Settings
    settings(const Problem<dim> &problem)
    {
      return {problem.time,
              problem.contact_parameters.algorithm,
              problem.contact_parameters.force_tolerance};
    }

    std::string
    step_in_words(const State &old_state, const double size)
    {
      std::ostringstream text;
      text << "step at t = " << old_state.time << " s of " << size << " s";
      return text.str();
    }
  } // namespace



  template <int dim>
  StepDriver<dim>::StepDriver(const Problem<dim> &problem, Timings &timings)
    : problem_(problem)
    , timings_(timings)
    , time_step_(*problem.solid, *problem.contact, settings(problem), timings)
  {}



  template <int dim>
  State
  StepDriver<dim>::initial_state()
  {
    try
      {
        if (problem_.time.initial_state == InitialState::as_given)
          return time_step_.initial_state(problem_.initial_displacement,
                                          problem_.initial_velocity,
                                          problem_.solid->initial_history());
        const State still = equilibrium();
        return time_step_.initial_state(still.displacement,
                                        problem_.initial_velocity,
                                        still.history);
      }
    catch (const NotPositiveDefinite &failure)
      {
        throw_not_positive_definite(failure.unknown);
      }
  }



  template <int dim>
  State
  StepDriver<dim>::equilibrium() const
  {
    auto still         = settings(problem_);
    still.time.dynamic = false;
    TimeStep<dim> step(*problem_.solid, *problem_.contact, still, timings_);
    const State   given = step.initial_state(problem_.initial_displacement,
                                           DofVector(problem_.solid->n_dofs()),
                                           problem_.solid->initial_history());
    const double  size  = problem_.time.step_control.initial_size;
    try
      {
        return step.advance(given, {0, -size, size});
      }
    catch (const StepFailed &failure)
      {
        throw ComputationError(
          std::string("Time / Initial state = static: ") + failure.what() +
          ". No equilibrium under the loads at t = 0 was found. Hold the bodies, "
          "let the loads grow in the run, or set Initial state = as given.");
      }
  }



  template <int dim>
  void
  StepDriver<dim>::advance(const double       target,
                           const std::string &folder,
                           RunRecord         &record,
                           Log               &log)
  {
    const StepControl &control = problem_.time.step_control;
    StepTrial          trial;
    trial.size =
      next_step_size(control, record.step_memory, record.state.time, target);
    while (true)
      {
        const Step  step{record.state.step + 1, record.state.time, trial.size};
        State       state;
        std::string failure;
        try
          {
            state = time_step_.advance(record.state, step);
            if (problem_.time.dynamic)
              failure = gain_of_step_in_words(record.state,
                                              state,
                                              record.largest_kinetic);
          }
        catch (const StepFailed &reason)
          {
            failure = reason.what();
          }
        catch (const NotPositiveDefinite &reason)
          {
            throw_not_positive_definite(reason.unknown);
          }
        trial.converged    = failure.empty();
        trial.n_iterations = state.n_iterations;
        trial.error =
          trial.converged ?
            error(record.state, state, step.size, record.largest_kinetic) :
            0.;
        if (problem_.output.logs_residuals)
          log_residuals(record.state, trial, log);
        const StepVerdict verdict =
          judge_step(control, record.step_memory, trial);
        if (verdict.is_accepted)
          {
            // A sum of many sizes misses the target by its rounding.
            if (control.automatic && StepPlan::is_met(state.time, target))
              state.time = target;
            accept(trial, verdict, std::move(state), record, log);
            return;
          }
        if (!trial.converged)
          report_failure(record.state, trial, verdict, failure, folder, log);
        else
          log.detail(step_in_words(record.state, trial.size) + ": " +
                     verdict.reason);
        ++(trial.converged ? record.counts.n_rejections : record.counts.n_cuts);
        record.step_memory   = verdict.memory;
        trial.rejected_error = trial.error;
        trial.size           = verdict.next_size;
      }
  }



  template <int dim>
  void
  StepDriver<dim>::relax(RunRecord &record, Log &log) const
  {
    auto still         = settings(problem_);
    still.time.dynamic = false;
    TimeStep<dim> step(*problem_.solid, *problem_.contact, still, timings_);
    State         state = record.state;
    state.contact_debt  = 0.;
    for (unsigned int i = 0; i < problem_.solid->dof_map().n_body_dofs(); ++i)
      state.velocity[i] = state.acceleration[i] = 0.;
    try
      {
        state = step.advance(state,
                             {state.step + 1,
                              state.time,
                              problem_.time.step_control.initial_size});
      }
    catch (const StepFailed &failure)
      {
        throw ComputationError(
          std::string("Final relaxation: ") + failure.what() +
          ". What was computed before is complete. A later End time, at which "
          "the bodies are quieter, helps; Final relaxation = none does without.");
      }
    const double loss =
      state.energy.scheme_loss() - record.state.energy.scheme_loss();
    state.energy.damping += loss;
    std::ostringstream message;
    message << "final relaxation: " << state.n_iterations << " iterations took "
            << loss << " J of vibration";
    log.line(message.str());
    record.state = std::move(state);
  }



  template <int dim>
  void
  StepDriver<dim>::damp(const std::string           &folder,
                        const std::function<void()> &is_made,
                        RunRecord                   &record,
                        Log                         &log)
  {
    constexpr double negligible = 1e-8;
    const double     size       = problem_.time.step_control.initial_size;
    const double     start      = record.state.energy.damping;
    double           highest = stop_bodies(record.state), last = 0.;
    unsigned int     n_steps    = 0;
    bool             is_at_rest = highest == 0.;
    while (!is_at_rest)
      {
        advance(record.state.time + size, folder, record, log);
        ++n_steps;
        State        still   = record.state;
        const double kinetic = stop_bodies(still);
        highest              = std::max(highest, kinetic);
        if (kinetic < last)
          {
            is_at_rest   = last < negligible * highest;
            record.state = std::move(still);
            last         = 0.;
          }
        else
          last = kinetic;
        is_made();
      }
    std::ostringstream message;
    message << "final relaxation: " << n_steps << " steps took "
            << record.state.energy.damping - start << " J of vibration";
    log.line(message.str());
  }



  template <int dim>
  double
  StepDriver<dim>::stop_bodies(State &state) const
  {
    const double kinetic = state.energy.kinetic;
    for (unsigned int i = 0; i < problem_.solid->dof_map().n_body_dofs(); ++i)
      state.velocity[i] = 0.;
    measure_kinetic_energy(problem_.solid->mass(), state);
    const double taken = kinetic - state.energy.kinetic;
    state.energy.damping += taken;
    return taken;
  }



  template <int dim>
  double
  StepDriver<dim>::error(const State &old_state,
                         const State &state,
                         const double step_size,
                         const double largest) const
  {
    const double tolerance = problem_.time.step_control.error_tolerance;
    if (!problem_.time.step_control.automatic || tolerance == 0.)
      return 0.;
    DofVector change(state.acceleration);
    change -= old_state.acceleration;
    const DofMatrix &mass = problem_.solid->mass();
    return relative_step_error(problem_.time.scheme,
                               step_size,
                               std::sqrt(mass.matrix_norm_square(change)),
                               std::sqrt(2. * std::max(largest,
                                                       state.energy.kinetic))) /
           tolerance;
  }



  template <int dim>
  void
  StepDriver<dim>::log_residuals(const State     &old_state,
                                 const StepTrial &trial,
                                 Log             &log) const
  {
    std::ostringstream text;
    text << step_in_words(old_state, trial.size) << ": residuals"
         << std::setprecision(3);
    for (const double residual : time_step_.residuals())
      text << ' ' << residual;
    log.detail(text.str());
  }



  template <int dim>
  void
  StepDriver<dim>::report_failure(const State       &old_state,
                                  const StepTrial   &trial,
                                  const StepVerdict &verdict,
                                  const std::string &reason,
                                  const std::string &folder,
                                  Log               &log) const
  {
    const std::string message =
      step_in_words(old_state, trial.size) + ": " + reason;
    if (verdict.next_size >= problem_.time.step_control.minimal_size)
      {
        log.line(message + "; " + verdict.reason);
        return;
      }
    write_interface(folder + "/interface_failed.txt", log);
    throw ComputationError(
      message + ". The step was cut down to the Minimal step size. Look at the "
                "last results to see what happens there. Often more Maximal "
                "iterations, smaller steps, or a finer mesh where contact "
                "happens help.");
  }



  template <int dim>
  void
  StepDriver<dim>::accept(const StepTrial   &trial,
                          const StepVerdict &verdict,
                          State            &&state,
                          RunRecord         &record,
                          Log               &log) const
  {
    StepCounts &counts = record.counts;
    counts.n_iterations += state.n_iterations;
    counts.n_tolerated += trial.error > 1.;
    counts.smallest = std::min(counts.smallest, trial.size);
    counts.largest  = std::max(counts.largest, trial.size);
    if (!time_step_.fallbacks().empty())
      {
        ++counts.n_fallbacks;
        log.detail("step " + std::to_string(state.step) +
                   ": the active set came back and a globally "
                   "convergent method solved the contact of " +
                   time_step_.fallbacks());
      }
    if (time_step_.approach() > 0.)
      {
        std::ostringstream message;
        message << "step " << state.step << ": the loads moved free bodies by "
                << time_step_.approach()
                << " m as a whole to where contact holds them";
        log.line(message.str());
      }
    if (!time_step_.mass_given_at().empty())
      log.line("step " + std::to_string(state.step) +
               ": without mass the stiffness was not positive definite at " +
               time_step_.mass_given_at() +
               ", and shorter steps do not help; all nodes keep their mass "
               "from now on (Contact mass = consistent)");
    if (!time_step_.indefinite_at().empty())
      log.detail("step " + std::to_string(state.step) +
                 ": the stiffness was not positive definite at " +
                 time_step_.indefinite_at() +
                 " on the way, and springs led around it");
    if (!verdict.reason.empty())
      {
        std::ostringstream message;
        message << "t = " << state.time << " s: " << verdict.reason;
        log.detail(message.str());
      }
    record.largest_kinetic =
      std::max(record.largest_kinetic, state.energy.kinetic);
    record.largest_energy =
      std::max(record.largest_energy,
               energy_turnover(state.energy, record.largest_kinetic));
    record.step_memory = verdict.memory;
    record.state       = std::move(state);
  }



  template <int dim>
  void
  StepDriver<dim>::throw_not_positive_definite(const unsigned int unknown) const
  {
    throw ComputationError(
      "The stiffness matrix is not positive definite at " +
      problem_.solid->unknown_in_words(unknown) +
      ": the body is not held, or a cell is turned inside out. Check its "
      "Supports and its mesh.");
  }



  template <int dim>
  void
  StepDriver<dim>::write_interface(const std::string &path, Log &log) const
  {
    std::ostringstream text;
    time_step_.write_last_problem(text);
    if (text.str().empty())
      return;
    std::ofstream(result_file(path)) << text.str();
    log.line("interface problem in " + path);
  }



#define INSTANTIATE(dim) template class StepDriver<dim>;
  SIGNORINI_FOR_EACH_DIMENSION(INSTANTIATE)
#undef INSTANTIATE
} // namespace Signorini
