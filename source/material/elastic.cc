#include <signorini/input/input_error.h>
#include <signorini/material/elastic.h>

#include <deal.II/base/parameter_handler.h>

namespace Signorini
{
  using namespace dealii;

  ElasticConstants
  ElasticConstants::from(const double youngs_modulus,
                         const double poissons_ratio)
  {
    return {youngs_modulus / (3. * (1. - 2. * poissons_ratio)),
            youngs_modulus / (2. * (1. + poissons_ratio))};
  }



  void
  ElasticConstants::declare_parameters(ParameterHandler &prm)
  {
    prm.declare_entry("Young's modulus",
                      "210e9",
                      Patterns::Double(),
                      "E > 0. Unit: Pa.");
    prm.declare_entry("Poisson's ratio",
                      "0.3",
                      Patterns::Double(),
                      "nu, greater than -1 and less than 0.5. Unit: 1.");
  }



  ElasticConstants
  ElasticConstants::parse(const ParameterHandler &prm)
  {
    const double youngs_modulus = prm.get_double("Young's modulus");
    const double poissons_ratio = prm.get_double("Poisson's ratio");
    if (!(youngs_modulus > 0.))
      throw InputError(
        "Young's modulus",
        "must be greater than zero, in Pa (steel: 210e9), found " +
          prm.get("Young's modulus") + ".");
    if (!(poissons_ratio > -1. && poissons_ratio < 0.5))
      throw InputError("Poisson's ratio",
                       "must lie between -1 and 0.5, both excluded, found " +
                         prm.get("Poisson's ratio") +
                         ". For a nearly incompressible material take 0.4999; "
                         "elements do not lock with Dilatation = automatic.");
    return from(youngs_modulus, poissons_ratio);
  }



  StrainResponse
  Elastic::respond(const SymmetricTensor<2, 3> &trial_strain,
                   const double /*step_size*/,
                   const PlasticState & /*state_n*/) const
  {
    const auto [bulk, shear]            = constants_;
    const double                volumic = trace(trial_strain);
    const SymmetricTensor<2, 3> shape   = deviator(trial_strain);
    StrainResponse              response;
    response.stress = 2. * shear * shape;
    for (unsigned int i = 0; i < 3; ++i)
      response.stress[i][i] += bulk * volumic;
    response.bulk  = bulk;
    response.shear = shear;
    response.energy_density =
      0.5 * bulk * volumic * volumic + shear * (shape * shape);
    return response;
  }
} // namespace Signorini
