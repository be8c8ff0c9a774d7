#ifndef signorini_solid_rigid_motion_h
#define signorini_solid_rigid_motion_h

#include <signorini/linear_algebra/types.h>
#include <signorini/solid/supports.h>

#include <string>
#include <vector>

namespace Signorini
{
  /** A motion of a connected part of a body as a whole. */
  struct RigidMode
  {
    std::string name;   // in words
    DofVector   motion; // of all unknowns, 1
  };

  /**
   * A basis of the rigid motions of each connected part that the fixed unknowns
   * leave free: the kernel of its rigid motions at the fixed unknowns, and
   * along the normals of sliding nodes. Lengths of rotations count in sizes of
   * the part.
   *
   * @param displacement of all unknowns, m: where the parts are
   */
  template <int dim>
  std::vector<RigidMode>
  free_rigid_modes(const Body<dim>                     &body,
                   const DofVector                     &displacement,
                   const DofMap                        &dof_map,
                   const std::vector<SlidingNode<dim>> &sliding_nodes = {});
} // namespace Signorini

#endif
