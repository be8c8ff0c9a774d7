#include <signorini/solid/stress_recovery.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_dgq.h>
#include <deal.II/fe/fe_tools.h>
#include <deal.II/fe/fe_values.h>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    using Component = std::pair<unsigned int, unsigned int>;

    // Those that a picture needs; in the plane xz and yz vanish.
    template <int dim>
    std::map<std::string, Component>
    components()
    {
      std::map<std::string, Component> list = {{"stress_xx", {0, 0}},
                                               {"stress_yy", {1, 1}},
                                               {"stress_zz", {2, 2}},
                                               {"stress_xy", {0, 1}}};
      if (dim == 3)
        {
          list["stress_yz"] = {1, 2};
          list["stress_xz"] = {0, 2};
        }
      return list;
    }

    double
    von_mises(const SymmetricTensor<2, 3> &stress)
    {
      return std::sqrt(1.5) * deviator(stress).norm();
    }

    double
    maximum_shear(const SymmetricTensor<2, 3> &stress)
    {
      const auto principal = eigenvalues(stress);
      return 0.5 * (principal[0] - principal[2]);
    }

    // The matrix that takes values at the quadrature points of a cell to its
    // nodes, through the polynomial that takes these values at the points.
    template <int dim>
    FullMatrix<double>
    extrapolation_matrix(const FE_Q<dim> &fe)
    {
      const QGauss<dim>  quadrature(fe.degree + 1);
      const FE_DGQ<dim>  smooth(fe.degree);
      FullMatrix<double> projection(smooth.n_dofs_per_cell(),
                                    quadrature.size());
      FETools::compute_projection_from_quadrature_points_matrix(smooth,
                                                                quadrature,
                                                                quadrature,
                                                                projection);
      FullMatrix<double> to_nodes(fe.n_dofs_per_cell(),
                                  smooth.n_dofs_per_cell());
      for (unsigned int a = 0; a < fe.n_dofs_per_cell(); ++a)
        for (unsigned int j = 0; j < smooth.n_dofs_per_cell(); ++j)
          to_nodes(a, j) =
            smooth.shape_value(j, fe.get_unit_support_points()[a]);
      FullMatrix<double> result(fe.n_dofs_per_cell(), quadrature.size());
      to_nodes.mmult(result, projection);
      return result;
    }
  } // namespace



  template <int dim>
  StressRecovery<dim>::StressRecovery(const Body<dim> &body)
    : body_(&body)
    , dof_handler_(*body.mesh().triangulation)
    , extrapolation_(extrapolation_matrix(body.scalar_fe()))
  {
    dof_handler_.distribute_dofs(body.scalar_fe());
  }



  template <int dim>
  std::map<std::string, Vector<double>>
  StressRecovery<dim>::fields(const Vector<double> &displacement) const
  {
    const Body<dim>  &body = *body_;
    const QGauss<dim> quadrature(body.scalar_fe().degree + 1);
    FEValues<dim>     values(body.mapping(),
                         body.scalar_fe(),
                         quadrature,
                         update_values | update_gradients |
                           update_quadrature_points);

    const unsigned int                   n_nodes = dof_handler_.n_dofs();
    std::vector<SymmetricTensor<2, 3>>   stress(n_nodes);
    std::vector<unsigned int>            n_cells(n_nodes);
    std::vector<types::global_dof_index> nodes(
      body.scalar_fe().n_dofs_per_cell());
    std::vector<types::global_dof_index> dofs(body.fe().n_dofs_per_cell());
    std::vector<SymmetricTensor<2, 3>>   at_points(quadrature.size());

    auto cell_with_dofs = body.dof_handler().begin_active();
    for (const auto &cell : dof_handler_.active_cell_iterators())
      {
        values.reinit(cell);
        cell->get_dof_indices(nodes);
        cell_with_dofs->get_dof_indices(dofs);
        for (const unsigned int q : values.quadrature_point_indices())
          {
            Tensor<2, dim> gradient;
            double         radial = 0.;
            for (const unsigned int a : values.dof_indices())
              for (unsigned int c = 0; c < dim; ++c)
                {
                  const double u =
                    displacement[body.first_dof() +
                                 dofs[body.fe().component_to_system_index(c,
                                                                          a)]];
                  gradient[c] += u * values.shape_grad(a, q);
                  if (c == 0)
                    radial += u * values.shape_value(a, q);
                }
            const double hoop_strain =
              body.formulation() == Formulation::axisymmetric ?
                radial / values.quadrature_point(q)[0] :
                0.;
            at_points[q] = respond(body.formulation(),
                                   body.material(cell->material_id()),
                                   gradient,
                                   hoop_strain,
                                   {})
                             .full_stress;
          }
        for (const unsigned int a : values.dof_indices())
          {
            ++n_cells[nodes[a]];
            for (const unsigned int q : values.quadrature_point_indices())
              stress[nodes[a]] += extrapolation_(a, q) * at_points[q];
          }
        ++cell_with_dofs;
      }

    std::map<std::string, Vector<double>> result;
    for (const auto &[name, component] : components<dim>())
      result[name].reinit(n_nodes);
    Vector<double> &mises = result["von_mises"];
    Vector<double> &shear = result["maximum_shear"];
    mises.reinit(n_nodes);
    shear.reinit(n_nodes);
    for (unsigned int n = 0; n < n_nodes; ++n)
      {
        stress[n] /= n_cells[n];
        for (const auto &[name, component] : components<dim>())
          result[name][n] = stress[n][component.first][component.second];
        mises[n] = von_mises(stress[n]);
        shear[n] = maximum_shear(stress[n]);
      }
    return result;
  }



  template <int dim>
  std::vector<Point<dim>>
  StressRecovery<dim>::points() const
  {
    std::vector<Point<dim>> result(dof_handler_.n_dofs());
    DoFTools::map_dofs_to_support_points(body_->mapping(),
                                         dof_handler_,
                                         result);
    return result;
  }



  template class StressRecovery<2>;
  template class StressRecovery<3>;
} // namespace Signorini
