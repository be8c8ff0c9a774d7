#ifndef signorini_geometry_mesh_topology_h
#define signorini_geometry_mesh_topology_h

#include <signorini/geometry/files/group_ids.h>
#include <signorini/geometry/files/mesh_data.h>

#include <array>
#include <vector>

namespace Signorini
{
  /**
   * The sorted nodes of a face; a line has two entries
   * dealii::numbers::invalid_unsigned_int at the end.
   */
  using FaceKey = std::array<unsigned int, 4>;

  /**
   * The elements of one kind, those with the same nodes once.
   * @param index_of_element position in the result for each element of the
   * file, dealii::numbers::invalid_unsigned_int for other kinds.
   * @throws InputError for an element that has a node twice.
   */
  std::vector<unsigned int>
  distinct_elements(const MeshData            &data,
                    const ElementKind          kind,
                    std::vector<unsigned int> &index_of_element);

  /**
   * The faces that belong to one cell only, sorted.
   * @throws InputError for a face of more than two cells.
   */
  std::vector<FaceKey>
  surface(const MeshData &data, const std::vector<unsigned int> &cells);

  /** The cells of a group. */
  NamedMembers
  cell_members(const MeshData::Group           &group,
               const std::vector<unsigned int> &index_of_element);

  /** Which faces of the surface belong to a group. */
  NamedMembers
  face_members(const MeshData::Group      &group,
               const MeshData             &data,
               const std::vector<FaceKey> &boundary_faces);
} // namespace Signorini

#endif
