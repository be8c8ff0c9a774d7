#ifndef signorini_solid_cell_dofs_h
#define signorini_solid_cell_dofs_h

#include <signorini/linear_algebra/types.h>
#include <signorini/solid/body.h>

#include <deal.II/base/tensor.h>

#include <vector>

namespace Signorini
{
  /** The unknowns of a cell in the counting of all bodies, node by node and
   * component by component, whatever the element's own order. */
  template <int dim>
  class CellDofs
  {
  public:
    explicit CellDofs(const Body<dim> &body)
      : dofs_(body.fe().n_dofs_per_cell())
      , indices_(dofs_.size())
      , first_dof_(body.first_dof())
    {
      for (unsigned int a = 0; a < body.scalar_fe().n_dofs_per_cell(); ++a)
        for (unsigned int c = 0; c < dim; ++c)
          order_.push_back(body.fe().component_to_system_index(c, a));
    }

    void
    reinit(const typename dealii::DoFHandler<dim>::active_cell_iterator &cell)
    {
      cell->get_dof_indices(indices_);
      for (unsigned int i = 0; i < dofs_.size(); ++i)
        dofs_[i] = first_dof_ + indices_[order_[i]];
    }

    const std::vector<dealii::types::global_dof_index> &
    all() const
    {
      return dofs_;
    }

    /** The components at node @p a of the cell. */
    dealii::Tensor<1, dim>
    at_node(const unsigned int a, const DofVector &values) const
    {
      dealii::Tensor<1, dim> result;
      for (unsigned int c = 0; c < dim; ++c)
        result[c] = values[dofs_[a * dim + c]];
      return result;
    }

    /** Adds to the components at node @p a of the cell. */
    void
    add(const unsigned int            a,
        const dealii::Tensor<1, dim> &force,
        DofVector                    &forces) const
    {
      for (unsigned int c = 0; c < dim; ++c)
        forces[dofs_[a * dim + c]] += force[c];
    }

  private:
    std::vector<dealii::types::global_dof_index> dofs_;
    std::vector<dealii::types::global_dof_index> indices_;
    std::vector<unsigned int>                    order_;
    unsigned int                                 first_dof_;
  };
} // namespace Signorini

#endif
