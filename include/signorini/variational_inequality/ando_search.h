#ifndef signorini_variational_inequality_ando_search_h
#define signorini_variational_inequality_ando_search_h

#include <signorini/variational_inequality/coulomb_system.h>
#include <signorini/variational_inequality/dense_factor.h>

#include <vector>

namespace Signorini
{
  /** The minimum of a friction problem with given bounds. */
  struct GivenBoundSolution
  {
    bool                      solved = false;
    std::vector<double>       x;
    unsigned int              n_iterations = 0; // faces of all programmes
    unsigned int              n_programmes = 0;
    std::vector<unsigned int> suspects     = {}; // contacts, if not solved
  };

  /**
   * Friction with given bounds f_k in two dimensions, by nondifferentiable
   * optimisation [MC, sec. 5.4, fig. 15]: the minimum of
   *
   *   1/2 du^T S du - du^T r + sum_k f_k |slip_k|   subject to   A du <= G
   *
   * as a finite sequence of convex quadratic programmes with signs s_k:
   *
   *  (i)   s_k is the sign of the slip at the start;
   *  (ii)  the cutting planes s_k slip_k >= 0 join the gap constraints, so that
   *        f_k |slip_k| = f_k s_k slip_k;
   *  (iii) the programme is solved exactly, with multipliers lambda_k >= 0 of
   *        the gaps and nu_k >= 0 of the planes, tau_k = s_k (f_k - nu_k);
   *  (iv)  active are the planes with nu_k > 0;
   *  (v)   the sign of an active plane is reversed if the objective falls on
   *        its other side. Its multiplier tells so without trying: there the
   *        same force belongs to the multiplier 2 f_k - nu_k, and the old
   *        minimum stays one as long as that is not negative. All planes with
   *        nu_k > 2 f_k are reversed at once, for the old minimum lies in all
   *        of them;
   *  (vi)  without such a plane, |tau_k| <= f_k: the minimum, with sticking
   *        contacts (0 <= nu_k <= 2 f_k) exactly at rest.
   *
   * The objective falls from one programme to the next, so that no set of signs
   * comes back. A programme that the first signs make contradictory (its forces
   * grow without bound) is one whose planes have to be reversed as well.
   */
  GivenBoundSolution
  solve_given_bounds(const CoulombSystem       &system,
                     const std::vector<double> &bounds,
                     const std::vector<double> &start);

  /**
   * Coulomb's law by solve_given_bounds(), the bound f_k = min(mu_k lambda_k,
   * largest friction) taken from the last iterate. [MC, sec. 5.2] repeats that
   * until the forces change by less than 0.01 %. Here each iterate proposes a
   * state (open, stick, slip), and the linear system of this state with the
   * bound inside, to which the repetition would lead, is solved at once. If it
   * confirms the state, the law holds exactly; otherwise the next bound
   * follows.
   *
   * From the forces of a last step or iteration only few contacts change their
   * state: up to four linear systems correct it, and only if none of them is
   * confirmed the planes are set up. If the bound does not settle, the fallback
   * for Coulomb's law goes on from the last point.
   */
  CoulombSolution
  solve_coulomb_ando(const CoulombSystem       &system,
                     const std::vector<double> &start,
                     DenseFactor               &factor);
} // namespace Signorini

#endif
