#include <signorini/contact/contactor_surface.h>

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
                               update_JxW_values);
    const auto            numbering =
      FETools::hierarchic_to_lexicographic_numbering<dim - 1>(fe.degree);
    for (const auto &cell : body.dof_handler().active_cell_iterators())
      for (const unsigned int face : cell->face_indices())
        {
          if (!cell->face(face)->at_boundary() ||
              cell->face(face)->boundary_id() != id)
            continue;
          const auto nodes = face_nodes(body, cell, face, node_of_dof);
          add_linear_pieces<dim>(nodes, fe.degree, surface.faces);
          values.reinit(static_cast<typename Triangulation<dim>::cell_iterator>(
                          cell),
                        face);
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
  double
  ContactorSurface<dim>::pressure(const unsigned int node,
                                  const double       force) const
  {
    return areas[node] > 0. ? force / areas[node] : 0.;
  }



  template struct ContactorSurface<2>;
  template struct ContactorSurface<3>;
  template ContactorSurface<2>
  contactor_surface(const Body<2> &, const std::string &);
  template ContactorSurface<3>
  contactor_surface(const Body<3> &, const std::string &);
} // namespace Signorini
