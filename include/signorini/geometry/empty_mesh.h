#ifndef signorini_geometry_empty_mesh_h
#define signorini_geometry_empty_mesh_h

#include <signorini/geometry/mesh.h>

namespace Signorini
{
  /**
   * More cells than anybody wants: a slip of the pen should end in a message,
   * not in a machine without memory.
   */
  constexpr double maximal_n_cells = 20e6;

  /**
   * A mesh without cells, ready for a generator: hanging nodes are limited to
   * one level at every vertex, distorted cells are noticed, and the cells will
   * belong to the region `body` (material id 0).
   */
  template <int dim>
  Mesh<dim>
  empty_mesh();
} // namespace Signorini

#endif
