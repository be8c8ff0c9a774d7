#ifndef signorini_solid_absorbing_boundary_h
#define signorini_solid_absorbing_boundary_h

#include <signorini/linear_algebra/types.h>
#include <signorini/solid/body.h>

#include <deal.II/lac/affine_constraints.h>

#include <set>

namespace Signorini
{
  /**
   * Adds the dashpots of boundaries at which waves leave the body,
   *   C_ab += int N_a N_b (sqrt(rho M) n n^T + sqrt(rho G) (1 - n n^T)) dA,
   * with the elastic moduli of compression waves M and of shear G. What comes
   * in along the normal is absorbed, what comes in obliquely mostly is
   * [LysmerKuhlemeyer1969].
   */
  template <int dim>
  void
  add_absorbing_boundaries(
    const Body<dim>                            &body,
    const std::set<dealii::types::boundary_id> &boundaries,
    const dealii::AffineConstraints<double>    &constraints,
    DofMatrix                                  &damping);
} // namespace Signorini

#endif
