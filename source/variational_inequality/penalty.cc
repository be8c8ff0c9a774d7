#include <signorini/input/input_error.h>
#include <signorini/variational_inequality/coulomb_fallback.h>
#include <signorini/variational_inequality/dual_solver.h>
#include <signorini/variational_inequality/penalty.h>

#include <cmath>
#include <sstream>

namespace Signorini
{
  namespace
  {
    void
    require_stiffness(const std::string &entry, const double value)
    {
      if (value > 0. && std::isfinite(value))
        return;
      std::ostringstream found;
      found << value;
      throw InputError("Contact / " + entry,
                       "found " + found.str() +
                         ", but the algorithm `penalty' needs a number greater "
                         "than zero. Ten to a thousand times the stiffness of "
                         "the body at a node is usual.");
    }
  } // namespace



  Penalty::Penalty(const double stiffness, const double tangential_stiffness)
    : stiffness(stiffness)
    , tangential_stiffness(tangential_stiffness == 0. ? stiffness :
                                                        tangential_stiffness)
  {
    require_stiffness("Penalty stiffness", stiffness);
    require_stiffness("Tangential penalty stiffness",
                      this->tangential_stiffness);
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
    terms.compliance            = 1. / stiffness;
    terms.tangential_compliance = 1. / tangential_stiffness;
    return solve_dual_with_friction(
      problem, starting_forces, solve_coulomb, /*exact=*/true, terms);
  }
} // namespace Signorini
