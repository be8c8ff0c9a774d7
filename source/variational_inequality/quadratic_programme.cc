#include <signorini/variational_inequality/dual_solver.h>
#include <signorini/variational_inequality/quadratic_programme.h>

namespace Signorini
{
  std::string
  QuadraticProgramme::name() const
  {
    return "quadratic programme";
  }



  bool
  QuadraticProgramme::enforces_exactly() const
  {
    return true;
  }



  InterfaceSolution
  QuadraticProgramme::solve_closed(const InterfaceProblem &problem,
                                   const InterfaceForces &starting_forces) const
  {
    return solve_dual(problem, starting_forces.normal);
  }
} // namespace Signorini
