#ifndef signorini_solid_mass_moments_h
#define signorini_solid_mass_moments_h

#include <signorini/linear_algebra/types.h>
#include <signorini/solid/body.h>
#include <signorini/solid/mass_redistribution.h>


namespace Signorini
{
  /**
   * Changes a redistributed mass matrix M_r so that every velocity field that
   * is affine in the place has the kinetic energy that it has with the original
   * M: then mass, centre of mass and moments of inertia are kept, also when the
   * body turns and stretches. Each entry is multiplied by
   *
   *   1 + (q(X_i) + q(X_j))/2,
   *
   * q the polynomial of second order for which a^T M_r b = a^T M b holds for
   * all a, b among the functions 1, X_c: the change of density that is least,
   * relative to the density, in the mean of its square. It is smooth, so that
   * no wave is reflected, and of second order in the size of the cells.
   *
   * Where too few nodes have mass to bear all moments at positive masses (two
   * layers of cells behind a surface in contact), M_r is left as it is, with
   * the right mass.
   *
   * @return false if a moment was not kept.
   */
  template <int dim>
  bool
  keep_moments(const Body<dim>          &body,
               const DofMatrix          &original,
               const MassRedistribution &redistribution,
               DofMatrix                &mass);
} // namespace Signorini

#endif
