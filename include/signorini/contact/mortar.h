#ifndef signorini_contact_mortar_h
#define signorini_contact_mortar_h

#include <signorini/contact/constraint_jacobian.h>

namespace Signorini
{
  /**
   * Mortar with piecewise constant multipliers on the dual mesh: one candidate
   * a node, whose gap is the mean over the share S_k of the surface
   * that is nearer to the node than to its neighbours (in an element of degree
   * 2 these are its mid-side nodes), as far as it has a target in reach,
   *
   *   g_k = 1/B_k int_{S_k} g dA,   B_k = int_{S_k} dA.
   *
   * The contact force lambda_k is a pressure p_k = lambda_k/B_k on this share.
   *
   *  - A uniform pressure is among these pressures: it is in balance on meshes
   *    that do not match, and its sum is right where the target ends opposite
   *    to an element. A node that is held, or has no more than a sliver of the
   *    target, has no contact force: its neighbour takes over its share.
   *  - Surfaces that do not overlap have no negative gap, however they are
   *    curved, and nothing is asked of a part that is beyond the target's end.
   *    Dual functions, int psi_k N_l dA = 0 for k != l [Wohlmuth2000], change
   *    their sign and know neither. What they are for, rows that do not couple
   *    the nodes of the contactor, the interface problem does not need. Of what
   *    is positive and adds up to one, the shares couple least.
   *
   * int_{S_k} N_l dA has singular values that do not depend on the number of
   * elements, for both degrees. Elements are cut where a node of the target
   * lies opposite.
   */
  std::vector<ContactPoint<2>>
  mortar_points(const PlacedPair<2> &placed);

  /** Not implemented in 3-D, where no .prm can ask for it. */
  std::vector<ContactPoint<3>>
  mortar_points(const PlacedPair<3> &placed);
} // namespace Signorini

#endif
