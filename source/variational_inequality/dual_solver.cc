#include <signorini/variational_inequality/dual_solver.h>

#include "dual_iteration.h"

namespace Signorini
{
  InterfaceSolution
  solve_dual(const InterfaceProblem    &problem,
             const std::vector<double> &starting_forces,
             const DualTerms           &terms)
  {
    const CoulombMethod none;
    return DualIteration(
             problem, InterfaceForces(starting_forces), none, true, terms)
      .run();
  }



  InterfaceSolution
  solve_dual_with_friction(const InterfaceProblem &problem,
                           const InterfaceForces  &starting_forces,
                           const CoulombMethod    &method,
                           const bool              exact,
                           const DualTerms        &terms)
  {
    return DualIteration(problem, starting_forces, method, exact, terms).run();
  }
} // namespace Signorini
