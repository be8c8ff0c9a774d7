#ifndef signorini_source_solid_cell_scratch_h
#define signorini_source_solid_cell_scratch_h

#include <signorini/solid/body.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>

#include "cell_dofs.h"

namespace Signorini
{
  /** What a thread keeps from cell to cell. */
  template <int dim>
  struct CellScratch
  {
    CellScratch(const Body<dim> &body, const dealii::UpdateFlags flags)
      : values(body.mapping(),
               body.scalar_fe(),
               dealii::QGauss<dim>(body.scalar_fe().degree + 1),
               flags)
      , dofs(body)
    {}

    CellScratch(const CellScratch &other)
      : values(other.values.get_mapping(),
               other.values.get_fe(),
               other.values.get_quadrature(),
               other.values.get_update_flags())
      , dofs(other.dofs)
    {}

    void
    visit(const typename dealii::DoFHandler<dim>::active_cell_iterator &cell)
    {
      values.reinit(
        static_cast<typename dealii::Triangulation<dim>::cell_iterator>(cell));
      dofs.reinit(cell);
    }

    dealii::FEValues<dim> values;
    CellDofs<dim>         dofs;
  };
} // namespace Signorini

#endif
