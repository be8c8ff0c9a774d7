#ifndef signorini_run_run_record_h
#define signorini_run_run_record_h

#include <signorini/dynamics/state.h>
#include <signorini/output/history.h>
#include <signorini/time/step_control.h>

#include <limits>

namespace Signorini
{
  /** How a run was stepped so far. */
  struct StepCounts
  {
    unsigned int n_cuts       = 0; // steps that did not converge
    unsigned int n_rejections = 0; // steps whose error was too large
    unsigned int n_tolerated  = 0; // accepted although it was
    unsigned int n_fallbacks  = 0; // steps
    unsigned int n_iterations = 0;
    double       smallest     = std::numeric_limits<double>::max(); // s
    double       largest      = 0.;                                 // s

    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int /*version*/)
    {
      archive &n_cuts &n_rejections &n_tolerated &n_fallbacks &n_iterations
        &smallest &largest;
    }
  };

  /**
   * What a run gathers from step to step. With the problem and the lists of
   * the files it is all that is needed to go on, so that checkpoints hold it.
   */
  struct RunRecord
  {
    State        state;
    History      history;
    StepMemory   step_memory;
    StepCounts   counts;
    double       largest_kinetic = 0.; // energy, J
    double       largest_energy  = 0.; // turnover at any time, J
    unsigned int n_regular       = 0;  // regular steps that are complete
    double       regular_time    = 0.; // s, at the end of the last of them
    unsigned int step_of_fields  = 0;  // of the last ones written

    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int /*version*/)
    {
      archive &state &history &step_memory &counts;
      archive &largest_kinetic             &largest_energy;
      archive &n_regular &regular_time     &step_of_fields;
    }
  };
} // namespace Signorini

#endif
