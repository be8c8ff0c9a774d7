#include <signorini/input/instantiate.h>
#include <signorini/solid/mass_matrix.h>

#include <deal.II/base/work_stream.h>

#include "cell_scratch.h"

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    struct MassCopy
    {
      explicit MassCopy(const unsigned int n_dofs)
        : mass(n_dofs, n_dofs)
        , dofs(n_dofs)
      {}

      FullMatrix<double>                   mass;
      std::vector<types::global_dof_index> dofs;
    };

    template <int dim>
    void
    cell_mass(const Body<dim>     &body,
              const double         density,
              const bool           lump,
              const double         factor,
              const FEValues<dim> &values,
              FullMatrix<double>  &mass)
    {
      mass = 0.;
      for (const unsigned int q : values.quadrature_point_indices())
        {
          const double weight = factor * density * values.JxW(q) *
                                body.volume_factor(values.quadrature_point(q));
          for (const unsigned int a : values.dof_indices())
            for (const unsigned int b : values.dof_indices())
              {
                const double entry =
                  weight * values.shape_value(a, q) * values.shape_value(b, q);
                for (unsigned int c = 0; c < dim; ++c)
                  mass(a * dim + c, (lump ? a : b) * dim + c) += entry;
              }
        }
    }
  } // namespace



  template <int dim>
  void
  add_mass(const Body<dim>                 &body,
           const AffineConstraints<double> &constraints,
           const bool                       lump,
           const double                     factor,
           DofMatrix                       &mass)
  {
    WorkStream::run(
      body.dof_handler().begin_active(),
      body.dof_handler().end(),
      [&](const auto &cell, CellScratch<dim> &scratch, MassCopy &copy) {
        scratch.visit(cell);
        copy.dofs = scratch.dofs.all();
        cell_mass(body,
                  body.material(cell->material_id()).density(),
                  lump,
                  factor,
                  scratch.values,
                  copy.mass);
      },
      [&](const MassCopy &copy) {
        constraints.distribute_local_to_global(copy.mass, copy.dofs, mass);
      },
      CellScratch<dim>(body,
                       update_values | update_quadrature_points |
                         update_JxW_values),
      MassCopy(body.fe().n_dofs_per_cell()));
  }



#define INSTANTIATE(dim)                                         \
  template void add_mass<dim>(const Body<dim> &,                 \
                              const AffineConstraints<double> &, \
                              const bool,                        \
                              const double,                      \
                              DofMatrix &);
  SIGNORINI_FOR_EACH_DIMENSION(INSTANTIATE)
#undef INSTANTIATE
} // namespace Signorini
