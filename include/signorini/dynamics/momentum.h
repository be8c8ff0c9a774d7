#ifndef signorini_dynamics_momentum_h
#define signorini_dynamics_momentum_h

#include <signorini/dynamics/state.h>
#include <signorini/linear_algebra/types.h>
#include <signorini/solid/solid_model.h>

#include <vector>

namespace Signorini
{
  /**
   * Of each body, with x = X + U the places of its nodes:
   *
   *   momentum sum_ij M_ij V_j, angular momentum about the origin
   *   sum_ij x_i x (M_ij V_j), centre of mass sum_ij M_ij x_j / sum_ij M_ij.
   *
   * Of an axisymmetric body only what is along the axis.
   */
  template <int dim>
  std::vector<BodyMotion>
  body_motions(const SolidModel<dim> &solid,
               const DofMatrix       &mass,
               const State           &state);
} // namespace Signorini

#endif
