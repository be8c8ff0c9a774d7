#include <signorini/dynamics/finite_state.h>
#include <signorini/input/as_text.h>
#include <signorini/input/input_error.h>
#include <signorini/input/instantiate.h>
#include <signorini/input/named_errors.h>
#include <signorini/output/progress.h>
#include <signorini/output/run_folder.h>
#include <signorini/run/energy_verdict.h>
#include <signorini/run/interruption.h>
#include <signorini/run/result_columns.h>
#include <signorini/run/simulation.h>

#include <boost/archive/binary_iarchive.hpp>
#include <boost/archive/binary_oarchive.hpp>

#include <iomanip>
#include <sstream>
#include <utility>

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

    const std::string checks_entry = "Expected results / Checks";

    std::string
    step_sizes_in_words(const StepCounts &counts)
    {
      std::ostringstream text;
      text << std::setprecision(4) << "steps of " << counts.smallest << " to "
           << counts.largest << " s, " << counts.n_rejections
           << " repeated for their error";
      if (counts.n_tolerated > 0)
        text << ", " << counts.n_tolerated
             << " accepted although shorter steps did not make it smaller";
      return text.str();
    }
  } // namespace



  template <int dim>
  Simulation<dim>::Simulation(const Problem<dim> &problem, Timings &timings)
    : problem_(problem)
    , timings_(timings)
    , watch_(problem)
    , driver_(problem, timings)
    , plan_(problem.time.step_control,
            problem.time.end_time,
            problem.output.interface_times,
            problem.output.time_between_fields)
    , fields_(problem)
    , expected_(with_entry(checks_entry,
                           [&] {
                             return ExpectedResults(problem.output.checks,
                                                    problem.constants);
                           }))
    , checkpoint_clock_(problem.output.steps_between_checkpoints,
                        problem.output.minutes_between_checkpoints)
    , columns_(result_columns(problem))
    , start_time_(0.)
    , start_(std::chrono::steady_clock::now())
  {
    record_.step_memory = StepMemory(problem.time.step_size);
    add_columns(columns_, record_.history);
    with_entry(checks_entry,
               [&] { expected_.check_names(record_.history, fields_); });
  }



  template <int dim>
  void
  Simulation<dim>::run(const RunTask &task, Log &log)
  {
    start_ = std::chrono::steady_clock::now();
    Files files(task.folder);
    if (task.checkpoint)
      resume(task, files, log);
    else
      begin(task, files);

    const unsigned int first   = record_.n_regular;
    const auto         goes_on = [&] {
      return !plan_.is_end(record_.state.time) &&
             !(task.max_steps && record_.n_regular - first >= *task.max_steps);
    };
    bool is_saved = task.checkpoint.has_value();
    while (goes_on())
      {
        make_step(task, files, log);
        is_saved = checkpoint_clock_.is_due() && save(task, files, log);
        if (is_interrupted() && goes_on())
          {
            const bool can_go_on = is_saved || save(task, files, log);
            finish(task, files);
            log.line(
              "interrupted at t = " + shortest_exact(record_.state.time) +
              " s; the results so far are complete");
            throw Interrupted(
              "Stopped as asked. The steps accepted so far are written." +
              (can_go_on ? " To go on: " + task.resume_command :
                           std::string()));
          }
      }
    const bool is_complete = plan_.is_end(record_.state.time);
    if (is_complete)
      relax(task, files, log);
    if (!is_saved && (!is_complete || !checkpoint_clock_.is_off()))
      is_saved = save(task, files, log);
    finish(task, files);
    watch_.look(record_.state, true, log);
    summarise(log);
    if (is_complete)
      check(log);
    else if (is_saved)
      log.line("to go on: " + task.resume_command);
  }



  template <int dim>
  void
  Simulation<dim>::begin(const RunTask &task, Files &files)
  {
    files.history =
      std::make_unique<HistoryWriter>(result_file(task.folder + "/history.csv"),
                                      record_.history);
    record_.state           = driver_.initial_state();
    record_.largest_kinetic = record_.state.energy.kinetic;
    record(true, files);
  }



  template <int dim>
  void
  Simulation<dim>::resume(const RunTask &task, Files &files, Log &log)
  {
    std::istringstream              stream(task.checkpoint->run);
    boost::archive::binary_iarchive archive(stream);
    try
      {
        archive >> record_ >> files.fields.collection() >>
          files.surfaces.collection() >> files.displacements;
      }
    catch (const std::exception &) // of Boost, or lengths that do not fit
      {
        throw InputError("--resume: the checkpoint does not fit this program. "
                         "Start the run anew without --resume.");
      }
    record_.n_regular =
      plan_.n_regular_at(record_.state.time, record_.n_regular);
    start_time_ = record_.state.time;
    files.history =
      std::make_unique<HistoryWriter>(result_file(task.folder + "/history.csv"),
                                      record_.history);
    files.fields.collection().cut_back();
    files.surfaces.collection().cut_back();
    files.displacements.cut_back();
    log.line("resumed at t = " + shortest_exact(start_time_) + " s, step " +
             std::to_string(record_.state.step));
  }



  template <int dim>
  void
  Simulation<dim>::make_step(const RunTask &task, Files &files, Log &log)
  {
    const double target = plan_.target(record_.state.time, record_.n_regular);
    try
      {
        driver_.advance(target, task.folder, record_, log);
      }
    catch (const ComputationError &)
      {
        // The last good state: other limits of the steps may help.
        if (record_.state.step > 0)
          save(task, files, log);
        throw;
      }
    const State &state = record_.state;
    if (!plan_.completes_regular_step(state.time, record_.n_regular))
      {
        record(false, files);
        watch_.look(state, false, log);
        return;
      }
    ++record_.n_regular;
    const double old_time = record_.regular_time;
    record_.regular_time  = state.time;
    if (problem_.output.interface_is_due(old_time, state.time))
      driver_.write_interface(task.folder + "/interface_" +
                                std::to_string(state.step) + ".txt",
                              log);
    const bool with_fields =
      problem_.output.fields_are_due(record_.n_regular, old_time, state.time);
    record(with_fields, files);
    watch_.look(state, with_fields, log);
    show_progress(log);
  }



  template <int dim>
  void
  Simulation<dim>::relax(const RunTask &task, Files &files, Log &log)
  {
    if (problem_.time.final_relaxation == FinalRelaxation::still)
      {
        driver_.relax(record_, log);
        record(false, files);
      }
    if (problem_.time.final_relaxation == FinalRelaxation::damped)
      driver_.damp(
        task.folder,
        [&]() {
          record(false, files);
          watch_.look(record_.state, false, log);
          show_progress(log);
          if (is_interrupted())
            throw Interrupted("Stopped as asked, in the final relaxation. The "
                              "history is complete up to here.");
        },
        record_,
        log);
  }



  template <int dim>
  void
  Simulation<dim>::record(const bool with_fields, Files &files)
  {
    const auto   timing = timings_.measure("output");
    const State &state  = record_.state;
    require_finite(state, *problem_.solid);
    append_row(columns_, problem_, state, record_.history);
    files.history->write_new_rows(record_.history);
    if (with_fields)
      write_fields(files);
  }



  template <int dim>
  void
  Simulation<dim>::write_fields(Files &files)
  {
    // Kept, because the checks at the end look at the last fields.
    shown_state_ = record_.state;
    fields_.show(shown_state_);
    fields_.write(files.fields, files.surfaces);
    if (problem_.output.keeps_displacements)
      fields_.write(files.displacements);
    record_.step_of_fields = record_.state.step;
  }



  template <int dim>
  bool
  Simulation<dim>::save(const RunTask &task, const Files &files, Log &log)
  {
    const auto timing = timings_.measure("checkpoints");
    files.history->flush();
    std::ostringstream              stream;
    boost::archive::binary_oarchive archive(stream);
    archive << record_ << std::as_const(files.fields).collection()
            << std::as_const(files.surfaces).collection()
            << std::as_const(files.displacements);
    try
      {
        write_checkpoint(task.folder,
                         {record_.state.time,
                          record_.state.step,
                          task.input,
                          task.geometry,
                          task.passes,
                          stream.str(),
                          ""});
        return true;
      }
    catch (const ComputationError &error)
      {
        log.line(error.what());
        return false;
      }
  }



  template <int dim>
  void
  Simulation<dim>::finish(const RunTask &task, Files &files)
  {
    const auto timing = timings_.measure("output");
    if (record_.step_of_fields != record_.state.step)
      write_fields(files);
    shown_state_ = record_.state;
    fields_.show(shown_state_);
    files.history->flush();
    fields_.write_contact_tables(task.folder);
  }



  template <int dim>
  void
  Simulation<dim>::show_progress(Log &log) const
  {
    if (!log.progress_is_due())
      return;
    const State &state = record_.state;
    Progress     progress;
    progress.step = state.step;
    progress.n_steps =
      state.step == record_.n_regular ? plan_.n_regular_steps() : 0;
    progress.time         = state.time;
    progress.start_time   = start_time_;
    progress.end_time     = plan_.end_time();
    progress.n_iterations = state.n_iterations;
    progress.n_contacts   = n_active_contacts(state);
    progress.elapsed      = seconds_since(start_);
    log.progress(progress_line(progress));
  }



  template <int dim>
  void
  Simulation<dim>::summarise(Log &log) const
  {
    const State       &state  = record_.state;
    const StepCounts  &counts = record_.counts;
    std::ostringstream text;
    text << std::setprecision(4) << "finished at t = " << state.time
         << " s: " << state.step << " steps, " << counts.n_iterations
         << " iterations ("
         << double(counts.n_iterations) / std::max(1u, state.step)
         << " a step), " << counts.n_cuts << " cuts, " << counts.n_fallbacks
         << " with cycles, " << format_duration(seconds_since(start_));
    log.line(text.str());
    if (problem_.time.step_control.automatic && state.step > 0)
      log.line(step_sizes_in_words(counts));

    const auto largest = [&](const std::string &column) {
      const auto values = record_.history.values(column);
      return *std::max_element(values.begin(), values.end());
    };
    std::ostringstream residuals;
    residuals << std::setprecision(2) << "largest residuals: forces "
              << largest("residual") << ", contact (KKT) "
              << largest("kkt_residual");
    log.line(residuals.str());

    log.line(ledger_in_words(state.energy));
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
    watch_.summarise(state, log);
    const std::string open =
      open_ledger_in_words(record_, problem_.time.dynamic, energy_rounding());
    if (!open.empty())
      log.line(open);
    log.line(timings_.table());
  }



  template <int dim>
  double
  Simulation<dim>::energy_rounding() const
  {
    const DofVector &displacement = record_.state.displacement;
    const DofVector  force    = problem_.solid->force_rounding(displacement);
    double           rounding = 0.;
    for (unsigned int i = 0; i < force.size(); ++i)
      rounding += std::abs(force[i] * displacement[i]);
    return rounding;
  }



  template <int dim>
  void
  Simulation<dim>::check(Log &log) const
  {
    refuse_made_energy(record_, energy_rounding());
    if (expected_.n_checks() == 0)
      return;
    const auto results = expected_.evaluate(record_.history, fields_);
    log.line(report(results));
    if (!all_passed(results))
      throw ExpectedResultsMissed(
        "The run is complete, but expected results were missed: see the lines "
        "above.");
  }



#define INSTANTIATE(dim) template class Simulation<dim>;
  SIGNORINI_FOR_EACH_DIMENSION(INSTANTIATE)
#undef INSTANTIATE
} // namespace Signorini
