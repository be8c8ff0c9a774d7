#include <signorini/variational_inequality/ando.h>
#include <signorini/variational_inequality/ando_search.h>
#include <signorini/variational_inequality/dual_solver.h>

namespace Signorini
{
  std::string
  Ando::name() const
  {
    return "ando";
  }



  bool
  Ando::enforces_exactly() const
  {
    return true;
  }



  InterfaceSolution
  Ando::solve_closed(const InterfaceProblem &problem,
                     const InterfaceForces  &starting_forces) const
  {
    refuse_three_dimensional_friction(problem, name());
    return solve_dual_with_friction(problem,
                                    starting_forces,
                                    solve_coulomb_ando);
  }
} // namespace Signorini
