#include <signorini/geometry/empty_mesh.h>
#include <signorini/geometry/files/group_ids.h>
#include <signorini/geometry/files/mesh_data.h>
#include <signorini/geometry/files/mesh_data_checks.h>
#include <signorini/geometry/mesh_topology.h>
#include <signorini/input/input_error.h>
#include <signorini/input/instantiate.h>

#include <deal.II/grid/grid_tools.h>

#include <algorithm>
#include <map>
#include <sstream>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    template <int dim>
    constexpr ElementKind cell_kind =
      dim == 2 ? ElementKind::quadrilateral : ElementKind::hexahedron;

    // Only the nodes of cells, with the new index of each.
    template <int dim>
    std::vector<Point<dim>>
    used_vertices(const MeshData                  &data,
                  const std::vector<unsigned int> &cells,
                  const double                     scale,
                  std::vector<unsigned int>       &vertex_of_node)
    {
      vertex_of_node.assign(data.nodes.size(), numbers::invalid_unsigned_int);
      std::vector<Point<dim>> vertices;
      for (const unsigned int c : cells)
        for (unsigned int v = 0; v < n_corners(cell_kind<dim>); ++v)
          {
            const unsigned int node = data.elements[c].nodes[v];
            if (vertex_of_node[node] != numbers::invalid_unsigned_int)
              continue;
            vertex_of_node[node] = vertices.size();
            Point<dim> vertex;
            for (unsigned int d = 0; d < dim; ++d)
              vertex[d] = scale * data.nodes[node][d];
            vertices.push_back(vertex);
          }
      return vertices;
    }

    // From corners that go around to deal.II's lexicographic order.
    template <int dim>
    std::vector<CellData<dim>>
    cell_data(const MeshData                  &data,
              const std::vector<unsigned int> &cells,
              const std::vector<unsigned int> &vertex_of_node,
              const std::vector<unsigned int> &material_ids)
    {
      const std::array<unsigned int, 8> position = {{0, 1, 3, 2, 4, 5, 7, 6}};

      std::vector<CellData<dim>> result(cells.size());
      for (unsigned int i = 0; i < cells.size(); ++i)
        {
          for (unsigned int v = 0; v < n_corners(cell_kind<dim>); ++v)
            result[i].vertices[position[v]] =
              vertex_of_node[data.elements[cells[i]].nodes[v]];
          result[i].material_id = material_ids[i];
        }
      return result;
    }

    template <int dim>
    void
    create_triangulation(const MeshData             &data,
                         std::vector<Point<dim>>    &vertices,
                         std::vector<CellData<dim>> &cells,
                         Triangulation<dim>         &triangulation)
    {
      try
        {
          GridTools::invert_cells_with_negative_measure(vertices, cells);
          GridTools::consistently_order_cells(cells);
          triangulation.create_triangulation(vertices, cells, SubCellData());
        }
      catch (const typename Triangulation<dim>::DistortedCellList &list)
        {
          std::ostringstream message;
          message << data.file_name << ": " << list.distorted_cells.size()
                  << " cells are twisted or have a corner of 180 degrees or "
                  << "more, the first one near ("
                  << list.distorted_cells.front()->center()
                  << "), in m. Mend the mesh there.";
          throw InputError(message.str());
        }
      catch (const ExceptionBase &)
        {
          throw InputError(data.file_name +
                           ": the elements do not form a mesh. Look for cells "
                           "that overlap and for faces that do not match.");
        }
    }

    template <int dim>
    FaceKey
    key_of(const typename Triangulation<dim>::face_iterator &face)
    {
      FaceKey key;
      key.fill(numbers::invalid_unsigned_int);
      for (const unsigned int v : face->vertex_indices())
        key[v] = face->vertex_index(v);
      std::sort(key.begin(), key.end());
      return key;
    }
  } // namespace



  unsigned int
  n_corners(const ElementKind kind)
  {
    const std::array<unsigned int, 9> n = {{1, 2, 3, 4, 4, 5, 6, 8, 0}};
    return n[static_cast<unsigned int>(kind)];
  }



  unsigned int
  dimension(const ElementKind kind)
  {
    const std::array<unsigned int, 9> n = {{0, 1, 2, 2, 3, 3, 3, 3, 0}};
    return n[static_cast<unsigned int>(kind)];
  }



  std::string
  location_of_node(const MeshData &data, const unsigned int node)
  {
    std::ostringstream text;
    text << "(" << data.nodes[node] << ")";
    return text.str();
  }



  template <int dim>
  Mesh<dim>
  build_mesh(const MeshData &data, const double scale)
  {
    // 1. The cells, without repetitions.
    check_kinds(data, dim);
    if (dim == 2)
      check_plane(data);
    std::vector<unsigned int>       cell_of_element;
    const std::vector<unsigned int> cells =
      distinct_elements(data, cell_kind<dim>, cell_of_element);
    const std::vector<FaceKey> boundary_faces = surface(data, cells);

    // 2. Ids from the groups. Of the faces only those on the surface count.
    std::vector<NamedMembers> regions, boundaries;
    for (const MeshData::Group &group : data.groups)
      if (group.dimension == dim)
        regions.push_back(cell_members(group, cell_of_element));
      else if (group.dimension == dim - 1)
        boundaries.push_back(face_members(group, data, boundary_faces));
    const GroupIds region_ids =
      assign_ids(regions, cells.size(), Overlap::leave_out, data.file_name);
    const GroupIds boundary_ids = assign_ids(boundaries,
                                             boundary_faces.size(),
                                             Overlap::refuse,
                                             data.file_name);
    check_named_boundaries(boundary_ids, data, dim);

    // 3. The triangulation.
    std::vector<unsigned int> vertex_of_node;
    std::vector<Point<dim>>   vertices =
      used_vertices<dim>(data, cells, scale, vertex_of_node);
    std::vector<CellData<dim>> cell_list =
      cell_data<dim>(data, cells, vertex_of_node, region_ids.id_of_member);
    Mesh<dim> mesh = empty_mesh<dim>();
    create_triangulation(data, vertices, cell_list, *mesh.triangulation);

    // 4. Names.
    std::map<FaceKey, unsigned int> id_of_face;
    for (unsigned int f = 0; f < boundary_faces.size(); ++f)
      {
        FaceKey key = boundary_faces[f];
        for (unsigned int &node : key)
          if (node != numbers::invalid_unsigned_int)
            node = vertex_of_node[node];
        std::sort(key.begin(), key.end());
        id_of_face[key] = boundary_ids.id_of_member[f];
      }
    for (const auto &face : mesh.triangulation->active_face_iterators())
      if (face->at_boundary())
        face->set_boundary_id(id_of_face.at(key_of<dim>(face)));

    mesh.boundaries.insert(boundary_ids.id_of_name.begin(),
                           boundary_ids.id_of_name.end());
    if (std::find(region_ids.id_of_member.begin(),
                  region_ids.id_of_member.end(),
                  0) == region_ids.id_of_member.end())
      mesh.regions.clear();
    mesh.regions.insert(region_ids.id_of_name.begin(),
                        region_ids.id_of_name.end());
    return mesh;
  }

#define INSTANTIATE(dim) \
  template Mesh<dim> build_mesh<dim>(const MeshData &, const double);
  SIGNORINI_FOR_EACH_DIMENSION(INSTANTIATE)
#undef INSTANTIATE
} // namespace Signorini
