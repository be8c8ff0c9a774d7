#ifndef signorini_solid_rigid_motion_h
#define signorini_solid_rigid_motion_h

#include <signorini/solid/supports.h>

#include <string>
#include <vector>

namespace Signorini
{
  /**
   * The rigid motion that the fixed unknowns of a body leave free, in words
   * ("translation along x", "rotation about z", ...); empty if none. Found as
   * the kernel of the rigid motions at the fixed unknowns, and along the
   * normals of sliding nodes.
   */
  template <int dim>
  std::string
  free_rigid_motion(const Body<dim>                     &body,
                    const std::vector<bool>             &is_fixed,
                    const std::vector<SlidingNode<dim>> &sliding_nodes = {});

  /** A motion of a body as a whole. */
  struct RigidMode
  {
    std::string            name;   // in words
    dealii::Vector<double> motion; // of all unknowns, 1
  };

  /** A basis of the rigid motions that the fixed unknowns leave free. */
  template <int dim>
  std::vector<RigidMode>
  free_rigid_modes(const Body<dim>                     &body,
                   const std::vector<bool>             &is_fixed,
                   const std::vector<SlidingNode<dim>> &sliding_nodes = {});
} // namespace Signorini

#endif
