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
   *  F = max over DoFs of |r|, |S du| and |A^T lambda + T^T tau|,
   *  l = max over contacts of |A_k| |S^-1 r| and |A_k| |du|, the same with T_k
   *      where there is friction, and of |G_k| and |s_k| where the contact is
   *      closed or carries a force.
   * If the scale is zero, so is what it divides. What is within the rounding of
   * the terms that were summed up, or of a gap or slip, counts as zero.
   */
  struct KKTResidual
  {
    double stationarity    = 0.; // max |S du - r + A^T lambda + T^T tau| / F, 1
    double penetration     = 0.; // max (A du - G)+, m
    double negative_force  = 0.; // max (-lambda)+, N
    double complementarity = 0.; // max over k of min(lambda_k / F, gap_k / l)+
    double friction_excess = 0.; // max (|tau_k| - f_k)+, N

    // Stick, slip and direction: max over k of the distance between tau_k / F
    // and the projection of tau_k / F + slip_k / l on the disc of radius
    // f_k / F, f_k = min(mu_k lambda_k, largest friction). 1
    double friction = 0.;

    double force_scale  = 0.; // F, N
    double length_scale = 0.; // l, m

    /** The largest of all, dimensionless; infinite if anything is not a
     * number. */
    double
    norm() const;
  };

  KKTResidual
  kkt_residual(const InterfaceProblem  &problem,
               const InterfaceSolution &solution);
} // namespace Signorini

#endif
