#ifndef signorini_dynamics_finite_state_h
#define signorini_dynamics_finite_state_h

#include <signorini/dynamics/state.h>
#include <signorini/solid/solid_model.h>

namespace Signorini
{
  /**
   * No state with an infinite value or a NaN may become a result: comparisons
   * with NaN are false, so that one can pass a test it should fail.
   * @throws ComputationError with the quantity, its place and the time
   */
  template <int dim>
  void
  require_finite(const State &state, const SolidModel<dim> &solid);
} // namespace Signorini

#endif
