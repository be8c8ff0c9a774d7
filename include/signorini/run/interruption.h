#ifndef signorini_run_interruption_h
#define signorini_run_interruption_h

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
   * one ends the program at once. A limit on the size of files (SIGXFSZ) is
   * treated like a full disk, which the writers report.
   */
  void
  catch_interruptions();

  /** To be asked between two steps: whether a signal has come meanwhile. */
  bool
  is_interrupted();
} // namespace Signorini

#endif
