#include <signorini/input/instantiate.h>
#include <signorini/solid/error_estimate.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/numerics/error_estimator.h>

#include <map>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    // C_xxxx of the material without history, Pa.
    double
    modulus(const Material &material)
    {
      const std::vector<double> history_n(material.n_history_values());
      std::vector<double>       history(history_n);
      return material
        .respond({Tensor<2, 3>(), {}, make_array_view(history_n)},
                 make_array_view(history))
        .tangent[0][0][0][0];
    }
  } // namespace



  template <int dim>
  std::vector<double>
  estimated_errors(const Body<dim> &body, const DofVector &displacement)
  {
    Vector<float> norms(body.mesh().triangulation->n_active_cells());
    KellyErrorEstimator<dim>::estimate(body.mapping(),
                                       body.dof_handler(),
                                       QGauss<dim - 1>(body.fe().degree + 1),
                                       {},
                                       body.extract(displacement),
                                       norms);
    std::map<types::material_id, double> moduli;
    std::vector<double>                  result;
    for (const auto &cell : body.dof_handler().active_cell_iterators())
      {
        const auto   id   = cell->material_id();
        const double norm = norms[cell->active_cell_index()];
        if (moduli.count(id) == 0)
          moduli[id] = modulus(body.material(id));
        result.push_back(moduli[id] * norm * norm *
                         body.volume_factor(cell->center()));
      }
    return result;
  }



#define INSTANTIATE(dim)                                           \
  template std::vector<double> estimated_errors(const Body<dim> &, \
                                                const DofVector &);
  SIGNORINI_FOR_EACH_DIMENSION(INSTANTIATE)
#undef INSTANTIATE
} // namespace Signorini
