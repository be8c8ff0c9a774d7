#include <signorini/input/instantiate.h>
#include <signorini/solid/occupied_region.h>

#include <algorithm>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    template <int dim>
    NodalMesh<dim>
    deformed_mesh(const Body<dim> &body, const DofVector &displacement)
    {
      NodalMesh<dim> mesh = nodal_mesh(body.dof_handler(), body.mapping());
      const auto     moved =
        nodal_values(body.dof_handler(), body.extract(displacement));
      for (unsigned int n = 0; n < mesh.nodes.size(); ++n)
        mesh.nodes[n] += moved[n];
      return mesh;
    }

    // The nodes of one linear piece of a face, from those of a cell of a degree
    // in lexicographic order.
    template <int dim>
    std::vector<std::vector<unsigned int>>
    pieces_of_face(const unsigned int face, const unsigned int degree)
    {
      const unsigned int        n         = degree + 1;
      const unsigned int        across    = face / 2;
      const unsigned int        strides[] = {1, n, n * n};
      const unsigned int        first     = face % 2 * degree * strides[across];
      std::vector<unsigned int> along; // strides in the face
      for (unsigned int d = 0; d < dim; ++d)
        if (d != across)
          along.push_back(strides[d]);
      std::vector<std::vector<unsigned int>> pieces;
      for (unsigned int j = 0; j < (dim == 3 ? degree : 1); ++j)
        for (unsigned int i = 0; i < degree; ++i)
          {
            const unsigned int corner =
              first + i * along[0] + (dim == 3 ? j * along.back() : 0);
            pieces.push_back({corner, corner + along[0]});
            if (dim == 3)
              for (unsigned int a = 0; a < 2; ++a)
                pieces.back().push_back(pieces.back()[a] + along.back());
          }
      return pieces;
    }

    // The cells of the mesh are the active ones in their order.
    template <int dim>
    SurfacePieces<dim>
    boundary_pieces(const Body<dim> &body, const NodalMesh<dim> &mesh)
    {
      std::vector<std::vector<Point<dim>>> pieces;
      const unsigned int                  *nodes = mesh.cells.data();
      for (const auto &cell : body.dof_handler().active_cell_iterators())
        {
          for (const unsigned int face : cell->face_indices())
            if (cell->face(face)->at_boundary())
              for (const auto &piece : pieces_of_face<dim>(face, mesh.degree))
                {
                  pieces.emplace_back();
                  for (const unsigned int a : piece)
                    pieces.back().push_back(mesh.nodes[nodes[a]]);
                }
          nodes += mesh.n_nodes_per_cell();
        }
      return SurfacePieces<dim>(std::move(pieces));
    }

    template <int dim>
    double
    largest_cell(const NodalMesh<dim> &mesh)
    {
      double largest = 0.;
      for (unsigned int c = 0; c < mesh.n_cells(); ++c)
        {
          std::vector<Point<dim>> points;
          for (unsigned int a = 0; a < mesh.n_nodes_per_cell(); ++a)
            points.push_back(
              mesh.nodes[mesh.cells[c * mesh.n_nodes_per_cell() + a]]);
          const auto corners = BoundingBox<dim>(points).get_boundary_points();
          largest = std::max(largest, corners.first.distance(corners.second));
        }
      return largest;
    }
  } // namespace



  template <int dim>
  OccupiedRegion<dim>::OccupiedRegion(const Body<dim> &body,
                                      const DofVector &displacement)
    : mesh_(deformed_mesh(body, displacement))
    , cells_(mesh_)
    , box_(mesh_.nodes)
    , boundary_(boundary_pieces(body, mesh_))
    , largest_cell_(::Signorini::largest_cell(mesh_))
  {}



  template <int dim>
  std::optional<double>
  OccupiedRegion<dim>::depth(const Point<dim> &point) const
  {
    if (!cells_.contains(point))
      return std::nullopt;
    return boundary_.nearest(point).second;
  }



  template <int dim>
  bool
  OccupiedRegion<dim>::is_near(const std::vector<Point<dim>> &points) const
  {
    return box_.get_neighbor_type(BoundingBox<dim>(points)) !=
           NeighborType::not_neighbors;
  }



  template <int dim>
  std::vector<Point<dim>>
  OccupiedRegion<dim>::cell_centres() const
  {
    const unsigned int      n_nodes = mesh_.n_nodes_per_cell();
    std::vector<Point<dim>> centres(mesh_.n_cells());
    for (unsigned int i = 0; i < mesh_.cells.size(); ++i)
      centres[i / n_nodes] += mesh_.nodes[mesh_.cells[i]] / double(n_nodes);
    return centres;
  }



#define INSTANTIATE(dim) template class OccupiedRegion<dim>;
  SIGNORINI_FOR_EACH_DIMENSION(INSTANTIATE)
#undef INSTANTIATE
} // namespace Signorini
