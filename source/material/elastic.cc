#include <signorini/input_error.h>
#include <signorini/material/elastic.h>

#include <deal.II/base/parameter_handler.h>

namespace Signorini
{
  using namespace dealii;

  Elastic::Elastic(const double youngs_modulus,
                   const double poissons_ratio,
                   const double density)
    : Material(density)
  {
    const double mu     = 0.5 * youngs_modulus / (1. + poissons_ratio);
    const double lambda = youngs_modulus * poissons_ratio /
                          ((1. + poissons_ratio) * (1. - 2. * poissons_ratio));
    tangent_ = lambda * outer_product(unit_symmetric_tensor<3>(),
                                      unit_symmetric_tensor<3>()) +
               2. * mu * identity_tensor<3>();
  }



  std::unique_ptr<Material>
  Elastic::create(const ParameterHandler &prm)
  {
    const double youngs_modulus = prm.get_double("Young's modulus");
    const double poissons_ratio = prm.get_double("Poisson's ratio");
    const double density        = prm.get_double("Density");
    if (youngs_modulus <= 0.)
      throw InputError("Young's modulus: must be greater than zero, "
                       "in Pa (steel: 210e9), found " +
                       prm.get("Young's modulus") + ".");
    if (poissons_ratio <= -1. || poissons_ratio >= 0.5)
      throw InputError("Poisson's ratio: must lie between -1 and "
                       "0.5, both excluded, found " +
                       prm.get("Poisson's ratio") +
                       ". For a nearly incompressible material take 0.499.");
    if (density < 0.)
      throw InputError("Density: must not be negative, in kg/m^3, "
                       "found " +
                       prm.get("Density") + ".");
    return std::make_unique<Elastic>(youngs_modulus, poissons_ratio, density);
  }



  MaterialResponse
  Elastic::respond(const Tensor<2, 3> &displacement_gradient,
                   const MaterialHistory & /*history_n*/) const
  {
    const SymmetricTensor<2, 3> strain = symmetrize(displacement_gradient);
    const SymmetricTensor<2, 3> stress = tangent_ * strain;
    return {stress, tangent_, 0.5 * (stress * strain), {}};
  }



  unsigned int
  Elastic::n_history_values() const
  {
    return 0;
  }



  bool
  Elastic::is_linear() const
  {
    return true;
  }
} // namespace Signorini
