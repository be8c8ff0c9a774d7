#ifndef signorini_variational_inequality_coulomb_gauss_seidel_h
#define signorini_variational_inequality_coulomb_gauss_seidel_h

#include <signorini/variational_inequality/coulomb_system.h>

#include <vector>

namespace Signorini
{
  /**
   * Nonsmooth block Gauss-Seidel sweeps [JourdanAlartJean1998]: Coulomb's
   * law is solved for one contact after the other, with the forces of all
   * others held. Slow, but hardly ever lost: it brings Newton's method near a
   * solution. Changes @p x; stops early once the law holds to rounding.
   *
   * @return true if it does.
   */
  bool
  sweep_coulomb(const CoulombSystem &system,
                const unsigned int   n_sweeps,
                std::vector<double> &x);
} // namespace Signorini

#endif
