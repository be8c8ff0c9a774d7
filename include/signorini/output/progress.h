#ifndef signorini_output_progress_h
#define signorini_output_progress_h

#include <string>

namespace Signorini
{
  /** The state of a run that is under way. */
  struct Progress
  {
    unsigned int step = 0;

    /** Number of steps in all; 0 when the step size is not fixed. */
    unsigned int n_steps = 0;

    /** Reached time and the times the run began and will end at. Unit: s. */
    double time       = 0.;
    double start_time = 0.;
    double end_time   = 0.;

    /** Iterations of this step, and nodes in contact after it. */
    unsigned int n_iterations = 0;
    unsigned int n_contacts   = 0;

    /** Wall-clock time since the run began at start_time. Unit: s. */
    double elapsed = 0.;
  };

  /**
   * One line, for instance
   *   step 1200/2400  t 6.000e-03 s  iterations 1  contacts 2  left 0:12
   * The time left is elapsed (1 - f) / f with f the part of the simulated time
   * that is done; it is left out while f = 0.
   */
  std::string
  progress_line(const Progress &progress);

  /** Wall-clock seconds as m:ss or h:mm:ss, rounded to whole seconds. */
  std::string
  format_duration(const double seconds);
} // namespace Signorini

#endif
