#ifndef signorini_variational_inequality_dual_solver_h
#define signorini_variational_inequality_dual_solver_h

#include <signorini/variational_inequality/coulomb_system.h>
#include <signorini/variational_inequality/dense_factor.h>
#include <signorini/variational_inequality/interface_problem.h>

#include <array>
#include <functional>
#include <vector>

namespace Signorini
{
  /** What an algorithm changes in the contact law of the dual programme. */
  struct DualTerms
  {
    // c: a closed contact gives way by c lambda_k. 0: rigid. m/N
    double compliance = 0.;

    // o_k: every gap is taken as G_k - o_k. Empty: all zero. m
    std::vector<double> offsets = {};

    // c_T: a contact that sticks gives way by c_T tau_k. 0: rigid. m/N
    double tangential_compliance = 0.;

    // Every slip is taken as s_k + o_k. Empty: all zero. m
    std::vector<std::array<double, 2>> slip_offsets = {};
  };

  /** A method for Coulomb's law on the dual: gets the system of the working
   * set, the forces it starts from, and the last factor. */
  using CoulombMethod =
    std::function<CoulombSolution(const CoulombSystem       &system,
                                  const std::vector<double> &start,
                                  DenseFactor               &factor)>;

  /**
   * Contact forces of an InterfaceProblem from its dual,
   *
   *   min 1/2 lambda^T (W + c I) lambda - lambda^T d,  lambda >= 0,
   *   W = A S^-1 A^T,  d = A S^-1 r - G + o,
   *   du = S^-1 (r - A^T lambda),
   *
   * so that lambda_k > 0 only where A_k du - G_k + o_k = c lambda_k, and
   * A_k du - G_k + o_k <= 0 elsewhere. Friction is left out.
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

  /**
   * The same with friction, for the forces lambda and tau together: a
   * CoulombSystem on the working set, solved by @p method.
   *
   * @param exact does @p method obey Coulomb's law to rounding? If not, the
   *   friction forces are taken as they are and only the normal forces are
   *   corrected until the gaps hold to rounding.
   * @throws InterfaceError as above, or if @p method finds no solution.
   */
  InterfaceSolution
  solve_dual_with_friction(const InterfaceProblem &problem,
                           const InterfaceForces  &starting_forces,
                           const CoulombMethod    &method,
                           const bool              exact = true,
                           const DualTerms        &terms = DualTerms());
} // namespace Signorini

#endif
