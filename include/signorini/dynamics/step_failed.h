#ifndef signorini_dynamics_step_failed_h
#define signorini_dynamics_step_failed_h

#include <stdexcept>

namespace Signorini
{
  /** A step that did not converge; a smaller one may. */
  class StepFailed : public std::runtime_error
  {
  public:
    using std::runtime_error::runtime_error;
  };
} // namespace Signorini

#endif
