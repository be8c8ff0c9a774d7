#ifndef signorini_variational_inequality_bound_constrained_qp_h
#define signorini_variational_inequality_bound_constrained_qp_h


#include <signorini/variational_inequality/interface_types.h>

#include <vector>

namespace Signorini
{
  /** How the search for a minimum ended. */
  enum class QPOutcome
  {
    solved,
    unbounded, // the objective falls without end
    stalled    // a set of free unknowns came back, or far too many were tried
  };

  /** A minimum of a bound constrained quadratic programme. */
  struct BoundConstrainedSolution
  {
    QPOutcome           outcome = QPOutcome::stalled;
    std::vector<double> x; // >= 0

    // Faces minimised on.
    unsigned int n_iterations = 0;

    // If unbounded, the unknowns that grow; if stalled, those that are
    // positive or still want to be.
    std::vector<unsigned int> suspects;
  };

  /**
   * min 1/2 x^T W x - d^T x subject to x >= 0, with W symmetric, positive
   * semidefinite and dense.
   *
   * 1. Exchange of blocks: the minimum on a face (the set of positive unknowns,
   *    the others zero) is found exactly by a Cholesky factorisation; negative
   *    unknowns leave and violated bounds are released, all at once, until none
   *    is left. Nearly always there in a handful of faces.
   * 2. If that makes no progress or meets a singular face, the method of
   *    [MoreToraldo1991] goes on from the best point: a projected gradient step
   *    chooses the face, the minimum on it is found exactly, and a projected
   *    search leads there. On a singular face the direction of zero curvature
   *    is followed to the next bound; if there is none, the programme is
   *    unbounded.
   *
   * In 2 the objective falls from one face minimum to the next, so that no face
   * comes back and the search ends. A face that does come back shows that
   * rounding decides: then tolerances are widened, step by step, to 1e-10 of
   * the numbers that cancel; if that does not help either, the outcome is
   * `stalled'.
   *
   * The search is invariant under a scaling of the unknowns or of the
   * objective.
   *
   * @param start where the search begins; negative entries count as zero. If
   *   its positive entries are those of the solution, one iteration is enough.
   * @param resolution changes of d below this are rounding error, in the unit
   *   of d.
   */
  BoundConstrainedSolution
  solve_bound_constrained_qp(const InterfaceMatrix     &W,
                             const std::vector<double> &d,
                             const std::vector<double> &start,
                             const double               resolution = 0.);
} // namespace Signorini

#endif
