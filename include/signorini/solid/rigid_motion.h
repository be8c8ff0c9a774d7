#ifndef signorini_solid_rigid_motion_h
#define signorini_solid_rigid_motion_h

#include <signorini/solid/body.h>

#include <string>
#include <vector>

namespace Signorini
{
  /**
   * The rigid motion that the fixed unknowns of a body leave free, in words
   * ("translation along x", "rotation about z", ...); empty if none. Found as
   * the kernel of the rigid motions at the fixed unknowns.
   */
  template <int dim>
  std::string
  free_rigid_motion(const Body<dim> &body, const std::vector<bool> &is_fixed);

  /** @throws InputError if a static run has no unique answer. */
  template <int dim>
  void
  refuse_free_rigid_motion(const Body<dim>         &body,
                           const std::vector<bool> &is_fixed);
} // namespace Signorini

#endif
