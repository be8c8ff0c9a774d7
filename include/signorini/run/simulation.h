#ifndef signorini_run_simulation_h
#define signorini_run_simulation_h

#include <signorini/output/checkpoint.h>
#include <signorini/output/displacement_writer.h>
#include <signorini/output/expected_results.h>
#include <signorini/output/field_writer.h>
#include <signorini/output/history_writer.h>
#include <signorini/output/log.h>
#include <signorini/output/surface_writer.h>
#include <signorini/output/timings.h>
#include <signorini/run/problem.h>
#include <signorini/run/result_columns.h>
#include <signorini/run/result_fields.h>
#include <signorini/run/run_record.h>
#include <signorini/run/state_watch.h>
#include <signorini/run/step_driver.h>
#include <signorini/time/step_plan.h>

#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace Signorini
{
  /** Run options: how to run, beside the problem. */
  struct RunTask
  {
    std::string                   folder;    // of the results; it exists
    std::optional<unsigned int>   max_steps; // regular ones; then stop
    std::vector<InputEntry>       input;     // kept in checkpoints
    unsigned int                  geometry;  // the same, a checksum
    std::vector<RefinementPasses> passes;    // the same, of each body
    std::string                   resume_command;
    std::optional<Checkpoint>     checkpoint; // from which to go on, if it fits
  };

  /** The time loop of one run: steps, results, checkpoints, checks. */
  template <int dim>
  class Simulation
  {
  public:
    /** The problem and the timings must outlive the object. */
    Simulation(const Problem<dim> &problem, Timings &timings);

    /**
     * Runs from t = 0, or from a checkpoint, to the end. Without the end there
     * are no checks.
     * @throws InputError if the checkpoint is of another program,
     * ComputationError when a step fails at the smallest size,
     * ExpectedResultsMissed, Interrupted. What was computed is on disk.
     */
    void
    run(const RunTask &task, Log &log);

  private:
    // The files of a run.
    struct Files
    {
      explicit Files(const std::string &folder)
        : fields(folder)
        , surfaces(folder)
        , displacements(folder)
      {}

      std::unique_ptr<HistoryWriter> history;
      FieldWriter<dim>               fields;
      SurfaceWriter<dim>             surfaces;
      DisplacementWriter<dim>        displacements; // for submodels
    };

    void
    begin(const RunTask &task, Files &files);

    void
    resume(const RunTask &task, Files &files, Log &log);

    // One step that is accepted, with its results.
    void
    make_step(const RunTask &task, Files &files, Log &log);

    void
    relax(const RunTask &task, Files &files, Log &log);

    void
    record(const bool with_fields, Files &files);

    void
    write_fields(Files &files);

    // Says how to go on. False, with the reason in the log, if it cannot be
    // written: that alone does not stop a run.
    bool
    save(const RunTask &task, const Files &files, Log &log);

    // The results at the last time, whether or not the run is complete.
    void
    finish(const RunTask &task, Files &files);

    void
    show_progress(Log &log) const;

    void
    summarise(Log &log) const;

    // What energies are known to, J.
    double
    energy_rounding() const;

    // Expected results, and the energy ledger.
    void
    check(Log &log) const;

    const Problem<dim>                   &problem_;
    Timings                              &timings_;
    StateWatch<dim>                       watch_;
    StepDriver<dim>                       driver_;
    StepPlan                              plan_;
    ResultFields<dim>                     fields_;
    ExpectedResults                       expected_;
    CheckpointClock                       checkpoint_clock_;
    std::vector<ResultColumn<dim>>        columns_;
    RunRecord                             record_;
    State                                 shown_state_; // of the last fields
    double                                start_time_;  // of this run, s
    std::chrono::steady_clock::time_point start_;
  };
} // namespace Signorini

#endif
