#ifndef signorini_variational_inequality_lemke_h
#define signorini_variational_inequality_lemke_h


#include <signorini/variational_inequality/interface_types.h>

#include <optional>
#include <vector>

namespace Signorini
{
  /**
   * The linear complementarity problem w = q + M z, w >= 0, z >= 0, w z = 0 by
   * Lemke's complementary pivoting with lexicographic ties
   * [CottlePangStone1992, ch. 4.4]. Entries of M should be of the order of one.
   * Finds a solution whenever M is copositive and z^T q >= 0 for every z of the
   * homogeneous problem.
   *
   * @param cover positive numbers of the order of one, one a row: the direction
   *   from which the solution is approached. Where a solution exists, but not
   *   by the rule above, another direction may find it.
   * @return z, to the rounding that pivoting gathers; nothing if it ends on a
   *   ray.
   */
  std::optional<std::vector<double>>
  solve_complementarity(const InterfaceMatrix     &M,
                        const std::vector<double> &q,
                        const std::vector<double> &cover);
} // namespace Signorini

#endif
