#include <signorini/contact/contactor_surface.h>
#include <signorini/input/instantiate.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_tools.h>
#include <deal.II/fe/fe_values.h>

#include <map>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    // The indices of the nodes on a face of a cell, in lexicographic order.
    template <int dim>
    std::vector<unsigned int>
    face_nodes(const Body<dim>                                      &body,
               const typename DoFHandler<dim>::active_cell_iterator &cell,
               const unsigned int                                    face,
               const std::map<unsigned int, unsigned int> &node_of_dof)
    {
      const FE_Q<dim> &fe = body.scalar_fe();
      const auto       numbering =
        FETools::hierarchic_to_lexicographic_numbering<dim - 1>(fe.degree);
      std::vector<types::global_dof_index> dofs(body.fe().n_dofs_per_cell());
      cell->get_dof_indices(dofs);
      std::vector<unsigned int> result(numbering.size());
      for (unsigned int i = 0; i < numbering.size(); ++i)
        {
          const unsigned int a = fe.face_to_cell_index(i, face);
          result[numbering[i]] = node_of_dof.at(
            body.first_dof() + dofs[body.fe().component_to_system_index(0, a)]);
        }
      return result;
    }

    // Mirrors the order of the nodes in the first direction.
    template <int dim>
    std::vector<unsigned int>
    mirrored(const std::vector<unsigned int> &nodes, const unsigned int degree)
    {
      std::vector<unsigned int> result(nodes);
      const unsigned int        row = degree + 1;
      for (unsigned int begin = 0; begin < nodes.size(); begin += row)
        std::reverse(result.begin() + begin, result.begin() + begin + row);
      return result;
    }

    // Twice the area (3-D) or the length (2-D) of a piece, times its normal.
    template <int dim>
    Tensor<1, dim>
    size_normal(const std::vector<unsigned int> &piece,
                const std::vector<Point<dim>>   &positions)
    {
      if constexpr (dim == 2)
        {
          const Tensor<1, dim> edge = positions[piece[1]] - positions[piece[0]];
          Tensor<1, dim>       normal;
          normal[0] = edge[1];
          normal[1] = -edge[0];
          return normal;
        }
      else
        // Half the cross product of the diagonals is the area vector.
        return cross_product_3d(positions[piece[3]] - positions[piece[0]],
                                positions[piece[2]] - positions[piece[1]]);
    }

    // The corner nodes of a face, as a linear piece has them.
    template <int dim>
    std::vector<unsigned int>
    corners(const std::vector<unsigned int> &nodes, const unsigned int degree)
    {
      if (dim == 2)
        return {nodes[0], nodes[degree]};
      const unsigned int last_row = degree * (degree + 1);
      return {nodes[0],
              nodes[degree],
              nodes[last_row],
              nodes[last_row + degree]};
    }

    // Cuts a face of degree p with (p+1)^(dim-1) nodes into linear pieces.
    template <int dim>
    void
    add_linear_pieces(const std::vector<unsigned int>        &nodes,
                      const unsigned int                      degree,
                      std::vector<std::vector<unsigned int>> &pieces)
    {
      const unsigned int row = degree + 1;
      if (dim == 2)
        for (unsigned int i = 0; i < degree; ++i)
          pieces.push_back({nodes[i], nodes[i + 1]});
      else
        for (unsigned int j = 0; j < degree; ++j)
          for (unsigned int i = 0; i < degree; ++i)
            {
              const unsigned int corner = i + j * row;
              pieces.push_back({nodes[corner],
                                nodes[corner + 1],
                                nodes[corner + row],
                                nodes[corner + row + 1]});
            }
    }
  } // namespace



  template <int dim>
  ContactorSurface<dim>
  contactor_surface(const Body<dim> &body, const std::string &boundary)
  {
    ContactorSurface<dim> surface;
    surface.nodes = body.boundary_nodes(boundary);
    surface.areas.resize(surface.nodes.size());
    surface.degree = body.scalar_fe().degree;
    std::vector<Point<dim>> points;
    for (const auto &node : surface.nodes)
      points.push_back(node.point);
    std::map<unsigned int, unsigned int> node_of_dof;
    for (unsigned int n = 0; n < surface.nodes.size(); ++n)
      node_of_dof[surface.nodes[n].dofs[0]] = n;

    const FE_Q<dim>      &fe = body.scalar_fe();
    const auto            id = body.mesh().boundary(boundary);
    const QGauss<dim - 1> quadrature(fe.degree + 1);
    FEFaceValues<dim>     values(body.mapping(),
                             fe,
                             quadrature,
                             update_values | update_quadrature_points |
                               update_normal_vectors | update_JxW_values);
    const auto            numbering =
      FETools::hierarchic_to_lexicographic_numbering<dim - 1>(fe.degree);
    for (const auto &cell : body.dof_handler().active_cell_iterators())
      for (const unsigned int face : cell->face_indices())
        {
          if (!cell->face(face)->at_boundary() ||
              cell->face(face)->boundary_id() != id)
            continue;
          const auto nodes = face_nodes(body, cell, face, node_of_dof);
          values.reinit(static_cast<typename Triangulation<dim>::cell_iterator>(
                          cell),
                        face);
          const bool is_outward =
            size_normal<dim>(corners<dim>(nodes, fe.degree), points) *
              values.normal_vector(0) >
            0.;
          surface.elements.push_back(
            is_outward ? nodes : mirrored<dim>(nodes, fe.degree));
          add_linear_pieces<dim>(surface.elements.back(),
                                 fe.degree,
                                 surface.faces);
          for (const unsigned int q : values.quadrature_point_indices())
            for (unsigned int i = 0; i < nodes.size(); ++i)
              surface.areas[nodes[numbering[i]]] +=
                values.shape_value(fe.face_to_cell_index(i, face), q) *
                values.JxW(q) * body.volume_factor(values.quadrature_point(q));
        }

    // An area that is zero but for rounding would make a pressure of it.
    const double largest =
      *std::max_element(surface.areas.begin(), surface.areas.end());
    for (double &area : surface.areas)
      if (area < 1e-10 * largest)
        area = 0.;
    return surface;
  }



  template <int dim>
  std::vector<Point<dim>>
  node_positions(const std::vector<Node<dim>> &nodes,
                 const DofVector              &displacement)
  {
    std::vector<Point<dim>> positions;
    positions.reserve(nodes.size());
    for (const auto &node : nodes)
      {
        Point<dim> position = node.point;
        for (unsigned int c = 0; c < dim; ++c)
          position[c] += displacement[node.dofs[c]];
        positions.push_back(position);
      }
    return positions;
  }



  template <int dim>
  std::vector<double>
  area_stretches(const ContactorSurface<dim>   &surface,
                 const Formulation              formulation,
                 const std::vector<Point<dim>> &positions)
  {
    std::vector<Point<dim>> reference;
    for (const auto &node : surface.nodes)
      reference.push_back(node.point);
    const auto size = [&](const std::vector<unsigned int> &piece,
                          const std::vector<Point<dim>>   &places) {
      double radius = 1.;
      if (formulation == Formulation::axisymmetric)
        radius = 0.5 * (places[piece[0]][0] + places[piece[1]][0]);
      return radius * size_normal<dim>(piece, places).norm();
    };
    std::vector<double> before(positions.size()), now(positions.size());
    for (const auto &piece : surface.faces)
      for (const unsigned int node : piece)
        {
          before[node] += size(piece, reference);
          now[node] += size(piece, positions);
        }
    for (unsigned int n = 0; n < now.size(); ++n)
      now[n] = before[n] > 0. ? now[n] / before[n] : 1.;
    return now;
  }



  template <int dim>
  std::vector<Tensor<1, dim>>
  node_normals(const ContactorSurface<dim>   &surface,
               const std::vector<Point<dim>> &positions)
  {
    std::vector<Tensor<1, dim>> normals(surface.nodes.size());
    for (const auto &piece : surface.faces)
      for (const unsigned int node : piece)
        normals[node] += size_normal<dim>(piece, positions);
    for (auto &normal : normals)
      if (normal.norm() > 0.)
        normal /= normal.norm();
    return normals;
  }



#define INSTANTIATE(dim)                                                   \
  template ContactorSurface<dim>   contactor_surface(const Body<dim> &,    \
                                                     const std::string &); \
  template std::vector<Point<dim>> node_positions(                         \
    const std::vector<Node<dim>> &, const DofVector &);                    \
  template std::vector<double> area_stretches(                             \
    const ContactorSurface<dim> &,                                         \
    const Formulation,                                                     \
    const std::vector<Point<dim>> &);                                      \
  template std::vector<Tensor<1, dim>> node_normals(                       \
    const ContactorSurface<dim> &, const std::vector<Point<dim>> &);
  SIGNORINI_FOR_EACH_DIMENSION(INSTANTIATE)
#undef INSTANTIATE
} // namespace Signorini
