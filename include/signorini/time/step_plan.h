#ifndef signorini_time_step_plan_h
#define signorini_time_step_plan_h

#include <signorini/time/step_control.h>

#include <vector>

namespace Signorini
{
  /**
   * The times at which steps have to end. Fixed steps meet the times of a
   * regular grid, k times the step size, automatic ones those of the output;
   * both meet the Times to meet of the control and the end.
   *
   * A regular step is what users count: with fixed steps the way from one time
   * of the grid to the next, in several steps where it was cut; with automatic
   * steps every step.
   */
  class StepPlan
  {
  public:
    /**
     * @param output_times    single times of the output, s
     * @param output_interval multiples of it are such times; 0: none. s
     */
    StepPlan(const StepControl         &control,
             const double               end_time,
             const std::vector<double> &output_times    = {},
             const double               output_interval = 0.);

    /** All regular steps; 0 if that is not known before. */
    unsigned int
    n_regular_steps() const;

    /**
     * The first time to meet after this one, s.
     * @param n_regular regular steps that are complete
     */
    double
    target(const double time, const unsigned int n_regular) const;

    /** True if the regular step after so many is complete at this time. */
    bool
    completes_regular_step(const double       time,
                           const unsigned int n_regular) const;

    /** The number of regular steps that a run has made when it gets to this
     * time: the old number, but for one that was cut short by an earlier end
     * of the run. */
    unsigned int
    n_regular_at(const double time, const unsigned int n_regular) const;

    /** True if nothing is left to do. */
    bool
    is_end(const double time) const;

    double
    end_time() const
    {
      return end_time_;
    }

    /** True if both times are the same but for rounding. */
    static bool
    is_met(const double time, const double target);

  private:
    // Of the grid of fixed steps.
    double
    grid_time(const unsigned int k) const;

    bool                is_automatic_;
    double              step_size_; // s
    double              end_time_;  // s
    double              interval_;  // s
    std::vector<double> times_;     // s, increasing
    unsigned int        n_grid_steps_;
  };
} // namespace Signorini

#endif
