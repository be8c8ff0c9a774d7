#ifndef signorini_geometry_files_mesh_data_checks_h
#define signorini_geometry_files_mesh_data_checks_h

#include <signorini/geometry/files/group_ids.h>
#include <signorini/geometry/files/mesh_data.h>

namespace Signorini
{
  /**
   * Are there cells of this dimension, all quadrilaterals or hexahedra?
   * @throws InputError
   */
  void
  check_kinds(const MeshData &data, const unsigned int dim);

  /** Do all quadrilaterals lie in the plane z = 0? @throws InputError */
  void
  check_plane(const MeshData &data);

  /** Has any boundary a name? @throws InputError */
  void
  check_named_boundaries(const GroupIds    &boundary_ids,
                         const MeshData    &data,
                         const unsigned int dim);
} // namespace Signorini

#endif
