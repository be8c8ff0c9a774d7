#include <signorini/input/instantiate.h>
#include <signorini/solid/assembler.h>
#include <signorini/solid/stress_recovery.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_dgq.h>
#include <deal.II/fe/fe_tools.h>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    struct StressComponent
    {
      std::string  name;
      unsigned int i, j;
    };

    // Those that a picture needs; in the plane xz and yz vanish.
    template <int dim>
    std::vector<StressComponent>
    components()
    {
      std::vector<StressComponent> list = {{"stress_xx", 0, 0},
                                           {"stress_yy", 1, 1},
                                           {"stress_zz", 2, 2},
                                           {"stress_xy", 0, 1}};
      if (dim == 3)
        {
          list.push_back({"stress_yz", 1, 2});
          list.push_back({"stress_xz", 0, 2});
        }
      return list;
    }

    double
    von_mises(const SymmetricTensor<2, 3> &stress)
    {
      return std::sqrt(1.5) * deviator(stress).norm();
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
  const std::vector<std::string> &
  StressRecovery<dim>::names()
  {
    static const std::vector<std::string> list = [] {
      std::vector<std::string> names;
      for (const StressComponent &component : components<dim>())
        names.push_back(component.name);
      for (const char *const name : {"von_mises",
                                     "maximum_shear",
                                     "principal_max",
                                     "principal_min",
                                     "plastic_strain"})
        names.emplace_back(name);
      return names;
    }();
    return list;
  }



  template <int dim>
  std::map<std::string, Vector<double>>
  StressRecovery<dim>::fields(const DofVector              &displacement,
                              const ArrayView<const double> history) const
  {
    const auto         at_points = point_values(*body_, displacement, history);
    const unsigned int n_nodes   = dof_handler_.n_dofs();
    std::vector<SymmetricTensor<2, 3>>   stress(n_nodes);
    Vector<double>                       plastic_strain(n_nodes);
    std::vector<unsigned int>            n_cells(n_nodes);
    std::vector<types::global_dof_index> nodes(
      body_->scalar_fe().n_dofs_per_cell());
    const unsigned int n_points = extrapolation_.n();
    for (const auto &cell : dof_handler_.active_cell_iterators())
      {
        cell->get_dof_indices(nodes);
        const unsigned int first = cell->active_cell_index() * n_points;
        for (unsigned int a = 0; a < nodes.size(); ++a)
          {
            ++n_cells[nodes[a]];
            for (unsigned int q = 0; q < n_points; ++q)
              {
                const double weight = extrapolation_(a, q);
                stress[nodes[a]] += weight * at_points.stresses[first + q];
                plastic_strain[nodes[a]] +=
                  weight * at_points.plastic_strains[first + q];
              }
          }
      }

    std::map<std::string, Vector<double>> result;
    for (const std::string &name : names())
      result[name].reinit(n_nodes);
    const auto all_components = components<dim>();
    for (unsigned int n = 0; n < n_nodes; ++n)
      {
        stress[n] /= n_cells[n];
        plastic_strain[n] /= n_cells[n];
        for (const StressComponent &component : all_components)
          result[component.name][n] = stress[n][component.i][component.j];
        const auto principal       = eigenvalues(stress[n]);
        result["von_mises"][n]     = von_mises(stress[n]);
        result["principal_max"][n] = principal[0];
        result["principal_min"][n] = principal[2];
        result["maximum_shear"][n] = 0.5 * (principal[0] - principal[2]);
      }
    result["plastic_strain"] = std::move(plastic_strain);
    return result;
  }



  template <int dim>
  IndexSet
  StressRecovery<dim>::boundary_nodes(const std::string &boundary) const
  {
    return DoFTools::extract_boundary_dofs(dof_handler_,
                                           ComponentMask(),
                                           {body_->mesh().boundary(boundary)});
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



#define INSTANTIATE(dim) template class StressRecovery<dim>;
  SIGNORINI_FOR_EACH_DIMENSION(INSTANTIATE)
#undef INSTANTIATE
} // namespace Signorini
