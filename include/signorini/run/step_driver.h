#ifndef signorini_run_step_driver_h
#define signorini_run_step_driver_h

#include <signorini/dynamics/time_step.h>
#include <signorini/output/log.h>
#include <signorini/output/timings.h>
#include <signorini/run/problem.h>
#include <signorini/run/run_record.h>

#include <functional>
#include <string>

namespace Signorini
{
  /**
   * Makes steps that are accepted: chooses their size, cuts those that do not
   * converge or whose error is too large, and counts.
   */
  template <int dim>
  class StepDriver
  {
  public:
    /** The problem and the timings must outlive the object. */
    StepDriver(const Problem<dim> &problem, Timings &timings);

    /** @throws ComputationError. */
    State
    initial_state();

    /**
     * One step from the state of the record towards a time. The record gets
     * the new state, and is as before if there is none.
     * @throws ComputationError when a step does not converge at the smallest
     * size; its interface problem is then in the folder.
     */
    void
    advance(const double       target,
            const std::string &folder,
            RunRecord         &record,
            Log               &log);

    /**
     * One more step without inertia, of bodies at rest: what they vibrate with
     * is gone, and residual stresses are left. Rigid bodies fly on. The energy
     * that this takes is counted as damped.
     * @throws ComputationError when it does not converge.
     */
    void
    relax(RunRecord &record, Log &log) const;

    /**
     * Steps in which the bodies are stopped whenever their kinetic energy
     * begins to fall, until its peaks are below 1e-8 of the first ones (dynamic
     * relaxation with kinetic damping [Cundall1976]). Rigid bodies fly on. The
     * energy that this takes is counted as damped.
     * @param is_made called after each step
     * @throws ComputationError as advance().
     */
    void
    damp(const std::string           &folder,
         const std::function<void()> &is_made,
         RunRecord                   &record,
         Log                         &log);

    /** Of the last iteration, as text, so that it can be solved alone. */
    void
    write_interface(const std::string &path, Log &log) const;

  private:
    // That a static step finds under the loads at t = 0.
    State
    equilibrium() const;

    // Takes the velocity from the bodies and returns their kinetic energy, J.
    double
    stop_bodies(State &state) const;

    // Over the tolerance; 0 if errors are not estimated.
    double
    error(const State &old_state,
          const State &state,
          const double step_size,
          const double largest) const;

    void
    log_residuals(const State     &old_state,
                  const StepTrial &trial,
                  Log             &log) const;

    // Gives up when the next trial would be too small.
    void
    report_failure(const State       &old_state,
                   const StepTrial   &trial,
                   const StepVerdict &verdict,
                   const std::string &reason,
                   const std::string &folder,
                   Log               &log) const;

    void
    accept(const StepTrial   &trial,
           const StepVerdict &verdict,
           State            &&state,
           RunRecord         &record,
           Log               &log) const;

    [[noreturn]] void
    throw_not_positive_definite(const unsigned int unknown) const;

    const Problem<dim> &problem_;
    Timings            &timings_;
    TimeStep<dim>       time_step_;
  };
} // namespace Signorini

#endif
