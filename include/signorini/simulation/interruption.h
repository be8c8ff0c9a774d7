#ifndef signorini_simulation_interruption_h
#define signorini_simulation_interruption_h

#include <stdexcept>

namespace Signorini
{
  /** The user stopped the run; what was written so far is complete. */
  class Interrupted : public std::runtime_error
  {
  public:
    using std::runtime_error::runtime_error;
  };

  /**
   * From now on the first Ctrl-C (SIGINT) or SIGTERM only leaves a mark, so
   * that a run can end between two steps with its files complete. A second
   * one ends the program at once.
   */
  void
  catch_interruptions();

  /**
   * To be called between two steps, with the files flushed.
   * @throws Interrupted when a signal has come in the meantime.
   */
  void
  stop_if_interrupted();
} // namespace Signorini

#endif
