#include <signorini/geometry/mesh_topology.h>
#include <signorini/input/input_error.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <map>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    // Corners of the faces of cells whose corners go around.
    const std::vector<std::vector<unsigned int>> &
    faces_of(const ElementKind kind)
    {
      static const std::vector<std::vector<unsigned int>> quadrilateral = {
        {0, 1}, {1, 2}, {2, 3}, {3, 0}};
      static const std::vector<std::vector<unsigned int>> hexahedron = {
        {0, 1, 2, 3},
        {4, 5, 6, 7},
        {0, 1, 5, 4},
        {1, 2, 6, 5},
        {2, 3, 7, 6},
        {3, 0, 4, 7}};
      return kind == ElementKind::quadrilateral ? quadrilateral : hexahedron;
    }

    FaceKey
    face_key(const std::array<unsigned int, 8> &nodes,
             const std::vector<unsigned int>   &corners)
    {
      FaceKey key;
      key.fill(numbers::invalid_unsigned_int);
      for (unsigned int i = 0; i < corners.size(); ++i)
        key[i] = nodes[corners[i]];
      std::sort(key.begin(), key.end());
      return key;
    }
  } // namespace



  std::vector<unsigned int>
  distinct_elements(const MeshData            &data,
                    const ElementKind          kind,
                    std::vector<unsigned int> &index_of_element)
  {
    index_of_element.assign(data.elements.size(),
                            numbers::invalid_unsigned_int);
    std::vector<unsigned int>                           distinct;
    std::map<std::array<unsigned int, 8>, unsigned int> known;
    for (unsigned int e = 0; e < data.elements.size(); ++e)
      {
        if (data.elements[e].kind != kind)
          continue;
        auto       key = data.elements[e].nodes;
        const auto end = key.begin() + n_corners(kind);
        std::fill(end, key.end(), numbers::invalid_unsigned_int);
        std::sort(key.begin(), key.end());
        if (std::adjacent_find(key.begin(), end) != end)
          throw InputError(
            data.file_name + ": a cell has two corners in the same node, at " +
            location_of_node(data, *std::adjacent_find(key.begin(), end)) +
            ". Mend the mesh there.");

        const auto [entry, is_new] = known.insert({key, distinct.size()});
        if (is_new)
          distinct.push_back(e);
        index_of_element[e] = entry->second;
      }
    return distinct;
  }



  std::vector<FaceKey>
  surface(const MeshData &data, const std::vector<unsigned int> &cells)
  {
    std::vector<FaceKey> all;
    for (const unsigned int c : cells)
      for (const auto &corners : faces_of(data.elements[c].kind))
        all.push_back(face_key(data.elements[c].nodes, corners));
    std::sort(all.begin(), all.end());

    std::vector<FaceKey> once;
    for (auto face = all.begin(); face != all.end();)
      {
        const auto next = std::upper_bound(face, all.end(), *face);
        if (next - face == 1)
          once.push_back(*face);
        if (next - face > 2)
          throw InputError(data.file_name + ": " + std::to_string(next - face) +
                           " cells share one face, which has a corner at " +
                           location_of_node(data, face->front()) +
                           ". At most two can; look for cells that overlap.");
        face = next;
      }
    return once;
  }



  NamedMembers
  cell_members(const MeshData::Group           &group,
               const std::vector<unsigned int> &index_of_element)
  {
    NamedMembers result = {group.name, group.is_automatic, {}};
    for (const unsigned int e : group.elements)
      result.members.push_back(index_of_element[e]);
    std::sort(result.members.begin(), result.members.end());
    result.members.erase(std::unique(result.members.begin(),
                                     result.members.end()),
                         result.members.end());
    return result;
  }



  NamedMembers
  face_members(const MeshData::Group      &group,
               const MeshData             &data,
               const std::vector<FaceKey> &boundary_faces)
  {
    const std::vector<unsigned int> line = {0, 1}, quadrilateral = {0, 1, 2, 3};

    NamedMembers result = {group.name, group.is_automatic, {}};
    for (const unsigned int e : group.elements)
      {
        const MeshData::Element &element = data.elements[e];
        if (element.kind != ElementKind::line &&
            element.kind != ElementKind::quadrilateral)
          continue;
        const FaceKey key =
          face_key(element.nodes,
                   element.kind == ElementKind::line ? line : quadrilateral);
        const auto found =
          std::lower_bound(boundary_faces.begin(), boundary_faces.end(), key);
        if (found != boundary_faces.end() && *found == key)
          result.members.push_back(found - boundary_faces.begin());
      }
    std::sort(result.members.begin(), result.members.end());
    result.members.erase(std::unique(result.members.begin(),
                                     result.members.end()),
                         result.members.end());
    return result;
  }
} // namespace Signorini
