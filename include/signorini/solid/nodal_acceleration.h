#ifndef signorini_solid_nodal_acceleration_h
#define signorini_solid_nodal_acceleration_h

#include <signorini/linear_algebra/types.h>
#include <signorini/solid/dof_map.h>

#include <vector>

namespace Signorini
{
  /**
   * Accelerations with M A = force on the unknowns that have mass.
   *
   * @param dof_map      those that it constrains keep their acceleration
   * @param force        N
   * @param acceleration a first guess, with what is given; the solution, m/s^2
   * @throws dealii::SolverControl::NoConvergence.
   */
  void
  accelerate(const DofMatrix &mass,
             const DofMap    &dof_map,
             const DofVector &force,
             DofVector       &acceleration);
} // namespace Signorini

#endif
