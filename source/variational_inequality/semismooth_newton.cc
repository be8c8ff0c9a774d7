#include <signorini/variational_inequality/coulomb_fallback.h>
#include <signorini/variational_inequality/dual_solver.h>
#include <signorini/variational_inequality/semismooth_newton.h>

namespace Signorini
{
  std::string
  SemismoothNewton::name() const
  {
    return "semismooth Newton";
  }



  bool
  SemismoothNewton::enforces_exactly() const
  {
    return true;
  }



  InterfaceSolution
  SemismoothNewton::solve_closed(const InterfaceProblem &problem,
                                 const InterfaceForces  &starting_forces) const
  {
    return solve_dual_with_friction(problem, starting_forces, solve_coulomb);
  }
} // namespace Signorini
