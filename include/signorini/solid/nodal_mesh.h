#ifndef signorini_solid_nodal_mesh_h
#define signorini_solid_nodal_mesh_h

#include <signorini/linear_algebra/types.h>

#include <deal.II/base/point.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/mapping.h>

#include <vector>

namespace Signorini
{
  /**
   * The nodes and cells of a body without its elements: all that is needed to
   * tell the displacement at any point. Cells are isoparametric: with the
   * Lagrange polynomials N_a of the nodes (Gauss-Lobatto, as FE_Q), and unit
   * coordinates xi, the point is sum N_a(xi) x_a and its displacement
   * sum N_a(xi) u_a.
   */
  template <int dim>
  struct NodalMesh
  {
    unsigned int degree = 1;

    /** Unit: m. */
    std::vector<dealii::Point<dim>> nodes;

    /** n_nodes_per_cell() indices into nodes a cell, those along x first. */
    std::vector<unsigned int> cells;

    unsigned int
    n_nodes_per_cell() const
    {
      return dealii::Utilities::pow(degree + 1, dim);
    }

    unsigned int
    n_cells() const
    {
      return cells.size() / n_nodes_per_cell();
    }
  };

  /**
   * The nodes in the order in which the cells meet them.
   * @param dof_handler of an FESystem of dim FE_Q
   * @param mapping of the degree of the elements, or a lower one
   */
  template <int dim>
  NodalMesh<dim>
  nodal_mesh(const dealii::DoFHandler<dim> &dof_handler,
             const dealii::Mapping<dim>    &mapping);

  /** The values at the nodes of nodal_mesh(). */
  template <int dim>
  std::vector<dealii::Tensor<1, dim>>
  nodal_values(const dealii::DoFHandler<dim> &dof_handler,
               const DofVector               &values);
} // namespace Signorini

#endif
