#ifndef signorini_solid_error_estimate_h
#define signorini_solid_error_estimate_h

#include <signorini/linear_algebra/types.h>
#include <signorini/solid/body.h>

#include <vector>

namespace Signorini
{
  /**
   * The estimate of [KellyGagoZienkiewiczBabuska1983] for the energy
   * of the error of each active cell:
   *   eta_K^2 = M h_K/24 int_{faces} |[du/dn]|^2 dA,
   * with the jump of the normal derivative and the modulus M = C_xxxx of the
   * cell. The jump of the traction is that of the derivative times the acoustic
   * tensor, whose largest eigenvalue is M, so that the two are equivalent.
   *
   * @param displacement of all unknowns, m
   * @return in the order of the active cells; J
   */
  template <int dim>
  std::vector<double>
  estimated_errors(const Body<dim> &body, const DofVector &displacement);
} // namespace Signorini

#endif
