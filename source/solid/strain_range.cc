#include <signorini/input/instantiate.h>
#include <signorini/solid/strain_range.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/fe/fe_values.h>

#include "cell_dofs.h"

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    // Of the skew part, whose rows tell the axis.
    template <int dim>
    double
    rotation_angle(const Tensor<2, dim> &gradient)
    {
      return (gradient - transpose(gradient)).norm() / std::sqrt(8.);
    }

    template <int dim>
    void
    include_point(const Tensor<2, dim> &gradient,
                  const double          hoop,
                  const Point<dim>     &centre,
                  StrainExtremes<dim>  &extremes)
    {
      double strain = std::abs(hoop);
      for (const double principal : eigenvalues(symmetrize(gradient)))
        strain = std::max(strain, std::abs(principal));
      const double rotation = rotation_angle(gradient);
      const double volume =
        determinant(unit_symmetric_tensor<dim>() + gradient) * (1. + hoop);
      if (strain > extremes.strain.value)
        extremes.strain = {strain, centre};
      if (rotation > extremes.rotation.value)
        extremes.rotation = {rotation, centre};
      if (volume < extremes.volume.value)
        extremes.volume = {volume, centre};
    }
  } // namespace



  template <int dim>
  StrainRange<dim>::StrainRange(const Body<dim> &body)
    : body_(&body)
  {
    CellDofs<dim> dofs(body);
    for (const auto &cell : body.dof_handler().active_cell_iterators())
      {
        shortest_edges_.push_back(cell->minimum_vertex_distance() /
                                  body.scalar_fe().degree);
        dofs.reinit(cell);
        dofs_.insert(dofs_.end(), dofs.all().begin(), dofs.all().end());
      }
  }



  template <int dim>
  bool
  StrainRange<dim>::is_moved(const unsigned int cell,
                             const DofVector   &displacement) const
  {
    const unsigned int  n_dofs  = body_->fe().n_dofs_per_cell();
    const unsigned int *dofs    = &dofs_[cell * n_dofs];
    double              largest = 0.;
    for (unsigned int i = dim; i < n_dofs; ++i)
      largest =
        std::max(largest,
                 std::abs(displacement[dofs[i]] - displacement[dofs[i % dim]]));
    return largest > 0.02 * shortest_edges_[cell];
  }



  template <int dim>
  StrainExtremes<dim>
  StrainRange<dim>::measure(const DofVector &displacement) const
  {
    const FE_Q<dim> &fe = body_->scalar_fe();
    FEValues<dim>    values(body_->mapping(),
                         fe,
                         QGauss<dim>(fe.degree + 1),
                         update_values | update_gradients |
                           update_quadrature_points);
    const bool       is_axisymmetric =
      body_->formulation() == Formulation::axisymmetric;
    StrainExtremes<dim> extremes;
    CellDofs<dim>       dofs(*body_);
    for (const auto &cell : body_->dof_handler().active_cell_iterators())
      {
        if (!is_moved(cell->active_cell_index(), displacement))
          continue;
        values.reinit(
          static_cast<typename Triangulation<dim>::cell_iterator>(cell));
        dofs.reinit(cell);
        for (const unsigned int q : values.quadrature_point_indices())
          {
            Tensor<2, dim> gradient;
            double         hoop = 0.;
            for (const unsigned int a : values.dof_indices())
              {
                const Tensor<1, dim> u = dofs.at_node(a, displacement);
                gradient += outer_product(u, values.shape_grad(a, q));
                if (is_axisymmetric)
                  hoop += u[0] * values.shape_value(a, q) /
                          values.quadrature_point(q)[0];
              }
            include_point(gradient, hoop, cell->center(), extremes);
          }
      }
    return extremes;
  }



#define INSTANTIATE(dim)               \
  template struct StrainExtremes<dim>; \
  template class StrainRange<dim>;
  SIGNORINI_FOR_EACH_DIMENSION(INSTANTIATE)
#undef INSTANTIATE
} // namespace Signorini
