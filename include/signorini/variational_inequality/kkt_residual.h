#ifndef signorini_variational_inequality_kkt_residual_h
#define signorini_variational_inequality_kkt_residual_h

#include <signorini/variational_inequality/interface_problem.h>

namespace Signorini
{
  /**
   * How far a solution is from the optimality (Karush-Kuhn-Tucker) conditions
   * of an InterfaceProblem. Algorithms, tests and the log all measure this.
   *
   * The scales come from the problem and the solution, so that norm() is the
   * same in every system of units:
   *  F = max over DoFs of |r|, |S du| and |A^T lambda|,
   *  l = max over contacts of |A_k| |S^-1 r| and |A_k| |du|, and of |G_k| where
   *      the contact is closed or carries a force.
   * If the scale is zero, so is what it divides.
   */
  struct KKTResidual
  {
    double stationarity    = 0.; // max |S du - r + A^T lambda| / F, 1
    double penetration     = 0.; // max (A du - G)+, m
    double negative_force  = 0.; // max (-lambda)+, N
    double complementarity = 0.; // max over k of min(lambda_k / F, gap_k / l)+

    double force_scale  = 0.; // F, N
    double length_scale = 0.; // l, m

    /** The largest of the four, dimensionless; infinite if anything is not a
     * number. */
    double
    norm() const;
  };

  KKTResidual
  kkt_residual(const InterfaceProblem  &problem,
               const InterfaceSolution &solution);
} // namespace Signorini

#endif
