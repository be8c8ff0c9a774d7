#ifndef signorini_variational_inequality_solution_refinement_h
#define signorini_variational_inequality_solution_refinement_h

#include <signorini/variational_inequality/interface_problem.h>

namespace Signorini
{
  /**
   * One step of iterative refinement: what a solution leaves of the balance of
   * forces, of closed gaps and of the slips of what sticks is solved for once
   * more, with the same contacts closed and the same ones slipping,
   *
   *   S d + A^T l + T^T t = r - S du - A^T lambda - T^T tau,
   *   A d = G - A du   where lambda > 0,
   *   T d = -s - T du  where it sticks,   t = mu l tau/|tau|  where it slips.
   *
   * A body that is soft beside the others loses digits in du, which are got
   * back. [Cf. Higham2002, ch. 12.]
   *
   * @return false if rows depend on each other: the solution is left as it was
   */
  bool
  refine(const InterfaceProblem &problem, InterfaceSolution &solution);
} // namespace Signorini

#endif
