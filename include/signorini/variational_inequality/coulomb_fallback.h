#ifndef signorini_variational_inequality_coulomb_fallback_h
#define signorini_variational_inequality_coulomb_fallback_h

#include <signorini/variational_inequality/coulomb_system.h>
#include <signorini/variational_inequality/dense_factor.h>

#include <vector>

namespace Signorini
{
  /**
   * Coulomb's law with one tangent a contact as a linear complementarity
   * problem [Klarbring1986; StewartTrinkle1996], solved by Lemke's
   * pivoting: for each contact lambda, tau = beta+ - beta-, and a slip gamma,
   *
   *   0 <= lambda  is complementary to  -e >= 0,
   *   0 <= beta+-  to  gamma -+ v >= 0,
   *   0 <= gamma   to  mu lambda - beta+ - beta- >= 0,
   *
   * and a second gamma for a largest friction. Its matrix is copositive.
   *
   * @param direction number of the direction from which the solution is
   *   approached.
   * @return the forces x, or an empty list if it ends on a ray.
   */
  std::vector<double>
  solve_coulomb_by_pivoting(const CoulombSystem &system,
                            const unsigned int   direction = 0);

  /**
   * What is done when a faster method came back to a state or did not converge:
   * block Gauss-Seidel sweeps, after some of which Newton's method tries to end
   * exactly; with one tangent a contact, then Lemke's pivoting from several
   * directions, and Newton's method from its result.
   *
   * @param start of the sweeps.
   */
  CoulombSolution
  solve_coulomb_fallback(const CoulombSystem       &system,
                         const std::vector<double> &start,
                         DenseFactor               &factor);

  /** Newton's method, and if it does not converge the fallback from its best
   * point. */
  CoulombSolution
  solve_coulomb(const CoulombSystem       &system,
                const std::vector<double> &start,
                DenseFactor               &factor);
} // namespace Signorini

#endif
