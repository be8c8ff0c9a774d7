#ifndef signorini_variational_inequality_dual_solver_h
#define signorini_variational_inequality_dual_solver_h

#include <signorini/variational_inequality/interface_problem.h>

#include <vector>

namespace Signorini
{
  /** What an algorithm changes in the contact law of the dual programme. */
  struct DualTerms
  {
    // c: a closed contact gives way by c lambda_k. 0: rigid. m/N
    double compliance = 0.;

    // o_k: every gap is taken as G_k - o_k. Empty: all zero. m
    std::vector<double> offsets;
  };

  /**
   * Contact forces of an InterfaceProblem from its dual,
   *
   *   min 1/2 lambda^T (W + c I) lambda - lambda^T d,  lambda >= 0,
   *   W = A S^-1 A^T,  d = A S^-1 r - G + o,
   *   du = S^-1 (r - A^T lambda),
   *
   * so that lambda_k > 0 only where A_k du - G_k + o_k = c lambda_k, and
   * A_k du - G_k + o_k <= 0 elsewhere.
   *
   * Works on a growing set of contacts, so that few responses are needed:
   * those with a starting force, or, if there are none, those that the free
   * displacement closes; then every contact that the result violates. Forces
   * are corrected with the gaps of the displacement itself until these hold to
   * rounding, about 1e-15 of the displacement.
   *
   * @param starting_forces lambda of the last step or iteration, or empty.
   * @throws InterfaceError if the constraints contradict each other or no
   *   solution to 1e-10 of the displacement is found.
   */
  InterfaceSolution
  solve_dual(const InterfaceProblem    &problem,
             const std::vector<double> &starting_forces,
             const DualTerms           &terms = DualTerms());
} // namespace Signorini

#endif
