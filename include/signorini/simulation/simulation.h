#ifndef signorini_simulation_simulation_h
#define signorini_simulation_simulation_h

#include <signorini/output/expected_results.h>
#include <signorini/output/field_writer.h>
#include <signorini/output/history.h>
#include <signorini/output/history_writer.h>
#include <signorini/output/log.h>
#include <signorini/output/surface_writer.h>
#include <signorini/output/timings.h>
#include <signorini/simulation/problem.h>
#include <signorini/simulation/result_fields.h>
#include <signorini/simulation/time_step.h>

#include <chrono>
#include <optional>
#include <string>

namespace Signorini
{
  /** The time loop of one run: steps, results, checks. */
  template <int dim>
  class Simulation
  {
  public:
    /** The problem and the timings must outlive the object. */
    Simulation(const Problem<dim> &problem, Timings &timings);

    /**
     * Runs from t = 0 to the end and writes into an existing folder.
     * @param max_steps stop after so many steps, without checks
     * @throws ComputationError when a step fails at the smallest size,
     * ExpectedResultsMissed, Interrupted. What was computed is on disk.
     */
    void
    run(const std::string                &folder,
        const std::optional<unsigned int> max_steps,
        Log                              &log);

  private:
    // The files of a run.
    struct Files
    {
      Files(const std::string &folder, const History &history);

      HistoryWriter      history;
      FieldWriter<dim>   fields;
      SurfaceWriter<dim> surfaces;
    };

    unsigned int
    n_grid_steps() const;

    // One step towards a time of the regular grid, cut in half until it
    // converges.
    State
    advance_towards(const State       &state,
                    const double       target,
                    const std::string &folder,
                    Log               &log);

    // As text, so that it can be solved alone.
    void
    write_interface(const std::string &path, Log &log) const;

    void
    record(const State &state, const bool with_fields, Files &files);

    void
    write_fields(const State &state, Files &files);

    void
    record_interruption(const State &state, Files &files, Log &log);

    [[noreturn]] void
    throw_not_positive_definite(const unsigned int unknown) const;

    void
    show_progress(const State &state, Log &log) const;

    void
    summarise(const State &state, Log &log) const;

    void
    check(Log &log) const;

    const Problem<dim>                   &problem_;
    Timings                              &timings_;
    TimeStep<dim>                         time_step_;
    ResultFields<dim>                     fields_;
    ExpectedResults                       expected_;
    History                               history_;
    State                                 shown_state_; // of the last fields
    double                                step_size_;   // of the last step
    unsigned int                          n_cuts_       = 0;
    unsigned int                          n_fallbacks_  = 0; // steps
    unsigned int                          n_iterations_ = 0;
    std::chrono::steady_clock::time_point start_;
  };
} // namespace Signorini

#endif
