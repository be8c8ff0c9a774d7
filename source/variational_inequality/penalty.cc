#include <signorini/input_error.h>
#include <signorini/variational_inequality/dual_solver.h>
#include <signorini/variational_inequality/penalty.h>

#include <cmath>
#include <sstream>

namespace Signorini
{
  Penalty::Penalty(const double stiffness)
    : stiffness(stiffness)
  {
    if (!(stiffness > 0.) || !std::isfinite(stiffness))
      {
        std::ostringstream found;
        found << stiffness;
        throw InputError("Contact / Penalty stiffness: found " + found.str() +
                         ", but the algorithm `penalty' needs a number greater "
                         "than zero. Ten to a thousand times the stiffness of "
                         "the body at a node is usual.");
      }
  }



  std::string
  Penalty::name() const
  {
    return "penalty";
  }



  bool
  Penalty::enforces_exactly() const
  {
    return false;
  }



  InterfaceSolution
  Penalty::solve_closed(const InterfaceProblem &problem,
                        const InterfaceForces  &starting_forces) const
  {
    DualTerms terms;
    terms.compliance = 1. / stiffness;
    return solve_dual(problem, starting_forces.normal, terms);
  }
} // namespace Signorini
