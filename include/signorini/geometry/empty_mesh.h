#ifndef signorini_geometry_empty_mesh_h
#define signorini_geometry_empty_mesh_h

#include <signorini/geometry/mesh.h>

namespace Signorini
{
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
