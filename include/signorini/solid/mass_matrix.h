#ifndef signorini_solid_mass_matrix_h
#define signorini_solid_mass_matrix_h

#include <signorini/linear_algebra/types.h>
#include <signorini/solid/body.h>

#include <deal.II/lac/affine_constraints.h>

namespace Signorini
{
  /**
   * Adds the mass matrix of a body, M_ab += factor int rho N_a N_b dV; lumped:
   * the sum of each row of a cell goes to the diagonal.
   */
  template <int dim>
  void
  add_mass(const Body<dim>                         &body,
           const dealii::AffineConstraints<double> &constraints,
           const bool                               lump,
           const double                             factor,
           DofMatrix                               &mass);
} // namespace Signorini

#endif
