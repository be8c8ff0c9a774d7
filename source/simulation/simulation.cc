#include <signorini/input_error.h>
#include <signorini/linear_algebra/sparse_cholesky.h>
#include <signorini/output/progress.h>
#include <signorini/simulation/history_columns.h>
#include <signorini/simulation/interruption.h>
#include <signorini/simulation/simulation.h>
#include <signorini/variational_inequality/interface_problem_io.h>

#include <fstream>
#include <iomanip>
#include <sstream>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    double
    seconds_since(const std::chrono::steady_clock::time_point start)
    {
      return std::chrono::duration<double>(std::chrono::steady_clock::now() -
                                           start)
        .count();
    }

    template <int dim>
    typename TimeStep<dim>::Settings
    settings(const Problem<dim> &problem)
    {
      return {problem.time,
              problem.contact_parameters.algorithm,
              problem.contact_parameters.force_tolerance};
    }

    // Errors in the checks name their entry.
    template <typename Action>
    auto
    in_checks(const Action &action)
    {
      try
        {
          return action();
        }
      catch (const InputError &error)
        {
          throw InputError(std::string("Expected results / Checks: ") +
                           error.what());
        }
    }

    // Times of the grid and of cut steps are sums; this much is rounding.
    constexpr double rounding = 1e-9;
  } // namespace



  template <int dim>
  Simulation<dim>::Files::Files(const std::string &folder,
                                const History     &history_columns)
    : history(folder + "/history.csv", history_columns)
    , fields(folder)
    , surfaces(folder)
  {}



  template <int dim>
  Simulation<dim>::Simulation(const Problem<dim> &problem, Timings &timings)
    : problem_(problem)
    , timings_(timings)
    , time_step_(*problem.solid, *problem.contact, settings(problem), timings)
    , fields_(problem)
    , expected_(
        in_checks([&] { return ExpectedResults(problem.output.checks); }))
    , step_size_(problem.time.step_size)
    , start_(std::chrono::steady_clock::now())
  {
    add_history_columns(problem, history_);
    in_checks([&] { expected_.check_names(history_, fields_); });
  }



  template <int dim>
  void
  Simulation<dim>::run(const std::string                &folder,
                       const std::optional<unsigned int> max_steps,
                       Log                              &log)
  {
    start_ = std::chrono::steady_clock::now();
    Files files(folder, history_);
    State state;
    try
      {
        state = time_step_.initial_state(problem_.initial_displacement,
                                         problem_.initial_velocity);
      }
    catch (const NotPositiveDefinite &error)
      {
        throw_not_positive_definite(error.unknown);
      }
    record(state, true, files);

    const unsigned int n_steps = n_grid_steps();
    for (unsigned int grid_step = 1; grid_step <= n_steps; ++grid_step)
      {
        const double target   = grid_step == n_steps ?
                                  problem_.time.end_time :
                                  grid_step * problem_.time.step_size;
        const double old_time = state.time;
        while (state.time < target * (1. - rounding))
          {
            state = advance_towards(state, target, folder, log);
            n_iterations_ += state.n_iterations;
            if (state.time < target * (1. - rounding))
              record(state, false, files);
          }
        if (problem_.output.interface_is_due(old_time, state.time))
          write_interface(folder + "/interface_" + std::to_string(state.step) +
                            ".txt",
                          log);
        const bool is_last =
          grid_step == n_steps || (max_steps && grid_step >= *max_steps);
        record(state,
               is_last || problem_.output.fields_are_due(grid_step,
                                                         old_time,
                                                         state.time),
               files);
        show_progress(state, log);
        if (is_last)
          break;
        try
          {
            stop_if_interrupted();
          }
        catch (const Interrupted &)
          {
            record_interruption(state, files, log);
            throw;
          }
      }
    files.history.flush();
    fields_.write_contact_tables(folder);
    summarise(state, log);
    if (!max_steps || *max_steps >= n_steps)
      check(log);
  }



  template <int dim>
  unsigned int
  Simulation<dim>::n_grid_steps() const
  {
    // A last step that would be tiny is added to the one before.
    const double n = problem_.time.end_time / problem_.time.step_size;
    return std::max(1., std::ceil(n - 1e-3));
  }



  template <int dim>
  State
  Simulation<dim>::advance_towards(const State       &state,
                                   const double       target,
                                   const std::string &folder,
                                   Log               &log)
  {
    // After a cut the steps grow again; the grid is met in any case. A step
    // that nearly reaches the grid takes the regular size exactly, so that the
    // factor of the last step can be used again.
    const double regular = problem_.time.step_size;
    double       size    = std::min(2. * step_size_, target - state.time);
    if (std::abs(size - regular) <= rounding * regular)
      size = regular;
    while (true)
      try
        {
          State next = time_step_.advance(state, size);
          step_size_ = size;
          if (!time_step_.fallbacks().empty())
            {
              ++n_fallbacks_;
              log.detail("step " + std::to_string(next.step) +
                         ": the active set came back and a globally "
                         "convergent method solved the contact of " +
                         time_step_.fallbacks());
            }
          return next;
        }
      catch (const StepFailed &failure)
        {
          ++n_cuts_;
          std::ostringstream message;
          message << "step at t = " << state.time << " s of " << size
                  << " s: " << failure.what();
          size *= 0.5;
          if (size < problem_.time.minimal_step_size)
            {
              write_interface(folder + "/interface_failed.txt", log);
              throw ComputationError(
                message.str() +
                ". The step was cut down to the Minimal step size. Look at the "
                "last results to see what happens there. Often more Maximal "
                "iterations, smaller steps, or a finer mesh where contact "
                "happens help.");
            }
          log.line(message.str() + "; cut in half");
        }
      catch (const NotPositiveDefinite &error)
        {
          throw_not_positive_definite(error.unknown);
        }
  }



  template <int dim>
  void
  Simulation<dim>::throw_not_positive_definite(const unsigned int unknown) const
  {
    for (const auto &part : problem_.solid->parts())
      for (const auto &node : part.body->nodes())
        for (const unsigned int dof : node.dofs)
          if (dof == unknown)
            {
              std::ostringstream message;
              message << "The stiffness matrix is not positive definite at "
                         "the node ("
                      << node.point << ") of body " << part.body->name()
                      << ": the body is not held, or a cell is turned inside "
                         "out. Check its Supports and its mesh.";
              throw ComputationError(message.str());
            }
    throw ComputationError("The stiffness matrix is not positive definite.");
  }



  template <int dim>
  void
  Simulation<dim>::record(const State &state,
                          const bool   with_fields,
                          Files       &files)
  {
    const auto timing = timings_.measure("output");
    append_history_row(problem_, state, history_);
    files.history.write_new_rows(history_);
    if (with_fields)
      write_fields(state, files);
  }



  template <int dim>
  void
  Simulation<dim>::write_fields(const State &state, Files &files)
  {
    // Kept, because the checks at the end look at the last fields.
    shown_state_ = state;
    fields_.show(shown_state_);
    fields_.write(files.fields, files.surfaces);
  }



  template <int dim>
  void
  Simulation<dim>::write_interface(const std::string &path, Log &log) const
  {
    if (time_step_.interface_problem().size() == 0)
      return;
    std::ofstream file(path);
    write_interface_problem(time_step_.interface_problem(), file);
    log.line("interface problem in " + path);
  }



  template <int dim>
  void
  Simulation<dim>::record_interruption(const State &state,
                                       Files       &files,
                                       Log         &log)
  {
    write_fields(state, files);
    files.history.flush();
    log.line("interrupted at t = " + std::to_string(state.time) +
             " s; the results so far are complete");
  }



  template <int dim>
  void
  Simulation<dim>::show_progress(const State &state, Log &log) const
  {
    if (!log.progress_is_due())
      return;
    Progress progress;
    progress.step         = state.step;
    progress.n_steps      = n_cuts_ == 0 ? n_grid_steps() : 0;
    progress.time         = state.time;
    progress.end_time     = problem_.time.end_time;
    progress.n_iterations = state.n_iterations;
    progress.n_contacts   = n_active_contacts(state);
    progress.elapsed      = seconds_since(start_);
    log.progress(progress_line(progress));
  }



  template <int dim>
  void
  Simulation<dim>::summarise(const State &state, Log &log) const
  {
    std::ostringstream text;
    text << std::setprecision(4) << "finished at t = " << state.time
         << " s: " << state.step << " steps, " << n_iterations_
         << " iterations (" << double(n_iterations_) / std::max(1u, state.step)
         << " a step), " << n_cuts_ << " cuts, " << n_fallbacks_
         << " with cycles, " << format_duration(seconds_since(start_));
    log.line(text.str());

    const auto largest = [&](const std::string &column) {
      const auto values = history_.values(column);
      return *std::max_element(values.begin(), values.end());
    };
    std::ostringstream residuals;
    residuals << std::setprecision(2) << "largest residuals: forces "
              << largest("residual") << ", contact (KKT) "
              << largest("kkt_residual");
    log.line(residuals.str());

    const EnergyLedger &energy = state.energy;
    std::ostringstream  ledger;
    ledger << std::setprecision(5) << "energy [J]: initial " << energy.initial
           << " + loads " << energy.loads << " + supports " << energy.supports
           << " + contact " << energy.contact << " + returned "
           << energy.returned << " = kinetic " << energy.kinetic << " + stored "
           << energy.stored << " + damping " << energy.damping << " + friction "
           << energy.friction << " + lost by the scheme "
           << energy.scheme_loss();
    log.line(ledger.str());
    for (const auto &pair : problem_.contact->pairs())
      {
        std::ostringstream line;
        line << std::setprecision(4) << "contact " << pair.name << ": "
             << pair.contactor.nodes.size()
             << " candidate nodes, largest pressure "
             << largest(pair.name + ".pressure_max")
             << " Pa, largest penetration "
             << largest(pair.name + ".penetration") << " m";
        log.line(line.str());
      }
    log.line(timings_.table());
  }



  template <int dim>
  void
  Simulation<dim>::check(Log &log) const
  {
    if (expected_.n_checks() == 0)
      return;
    const auto results = expected_.evaluate(history_, fields_);
    log.line(report(results));
    if (!all_passed(results))
      throw ExpectedResultsMissed(
        "The run is complete, but expected results were missed: see the lines "
        "above.");
  }



  template class Simulation<2>;
  template class Simulation<3>;
} // namespace Signorini
