#include <signorini/input/instantiate.h>
#include <signorini/solid/nodal_mesh.h>

#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe.h>
#include <deal.II/fe/fe_tools.h>

#include <array>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    // Calls visit(dofs, is_new, node) for each node of each cell.
    template <int dim, typename Visitor>
    void
    visit_nodes(const DoFHandler<dim> &dof_handler, const Visitor &visit)
    {
      const FiniteElement<dim> &fe = dof_handler.get_fe();
      AssertDimension(fe.n_components(), dim);
      const std::vector<unsigned int> in_order =
        FETools::lexicographic_to_hierarchic_numbering<dim>(fe.degree);
      AssertDimension(dim * in_order.size(), fe.n_dofs_per_cell());

      // Of the first component.
      std::vector<unsigned int>            node_of_dof(dof_handler.n_dofs(),
                                            numbers::invalid_unsigned_int);
      std::vector<types::global_dof_index> indices(fe.n_dofs_per_cell());
      unsigned int                         n_nodes = 0;
      for (const auto &cell : dof_handler.active_cell_iterators())
        {
          cell->get_dof_indices(indices);
          for (const unsigned int a : in_order)
            {
              std::array<types::global_dof_index, dim> dofs;
              for (unsigned int c = 0; c < dim; ++c)
                dofs[c] = indices[fe.component_to_system_index(c, a)];
              unsigned int &node   = node_of_dof[dofs[0]];
              const bool    is_new = node == numbers::invalid_unsigned_int;
              if (is_new)
                node = n_nodes++;
              visit(dofs, is_new, node);
            }
        }
    }
  } // namespace



  template <int dim>
  NodalMesh<dim>
  nodal_mesh(const DoFHandler<dim> &dof_handler, const Mapping<dim> &mapping)
  {
    std::vector<Point<dim>> points(dof_handler.n_dofs());
    DoFTools::map_dofs_to_support_points(mapping, dof_handler, points);
    NodalMesh<dim> mesh;
    mesh.degree = dof_handler.get_fe().degree;
    visit_nodes(dof_handler,
                [&](const auto &dofs, const bool is_new, const auto node) {
                  if (is_new)
                    mesh.nodes.push_back(points[dofs[0]]);
                  mesh.cells.push_back(node);
                });
    return mesh;
  }



  template <int dim>
  std::vector<Tensor<1, dim>>
  nodal_values(const DoFHandler<dim> &dof_handler, const DofVector &values)
  {
    AssertDimension(values.size(), dof_handler.n_dofs());
    std::vector<Tensor<1, dim>> result;
    visit_nodes(dof_handler,
                [&](const auto &dofs, const bool is_new, const auto) {
                  if (!is_new)
                    return;
                  result.emplace_back();
                  for (unsigned int c = 0; c < dim; ++c)
                    result.back()[c] = values[dofs[c]];
                });
    return result;
  }

#define INSTANTIATE(dim)                                                        \
  template struct NodalMesh<dim>;                                               \
  template NodalMesh<dim>              nodal_mesh<dim>(const DoFHandler<dim> &, \
                                          const Mapping<dim> &);   \
  template std::vector<Tensor<1, dim>> nodal_values<dim>(                       \
    const DoFHandler<dim> &, const DofVector &);
  SIGNORINI_FOR_EACH_DIMENSION(INSTANTIATE)
#undef INSTANTIATE
} // namespace Signorini
