#ifndef signorini_contact_mortar_h
#define signorini_contact_mortar_h

#include <signorini/contact/contact_rows.h>

namespace Signorini
{
  /**
   * One candidate a node: its gap is the mean of the gaps on the surface
   * around, weighted with the dual function psi_k of the node,
   *
   *   g_k = int psi_k g dA / B_k,   B_k = int psi_k dA = int N_k dA,
   *   int psi_k N_l dA = delta_kl B_k   on every element,
   *
   * so that lambda_k = B_k p_k with the contact pressure p_k of the node, and a
   * uniform pressure is in balance on meshes that do not match (Wohlmuth
   * 2000; Popp, Gee & Wall 2009). Elements are cut where a node of the target
   * lies opposite; what has no target in reach does not count.
   */
  std::vector<ContactPoint<2>>
  mortar_points(const PlacedPair<2> &placed);

  /** Not implemented in 3-D, where no .prm can ask for it. */
  std::vector<ContactPoint<3>>
  mortar_points(const PlacedPair<3> &placed);
} // namespace Signorini

#endif
