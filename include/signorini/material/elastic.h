#ifndef signorini_material_elastic_h
#define signorini_material_elastic_h

#include <signorini/material/material.h>

namespace Signorini
{
  /**
   * Isotropic linear elasticity for small strains,
   *   stress = lambda tr(strain) 1 + 2 mu strain,
   * with lambda = E nu / ((1 + nu)(1 - 2 nu)) and mu = E / (2 (1 + nu)).
   */
  class Elastic : public Material
  {
  public:
    /**
     * @param youngs_modulus E > 0, Pa
     * @param poissons_ratio -1 < nu < 1/2
     * @param density        kg/m^3, >= 0
     */
    Elastic(const double youngs_modulus,
            const double poissons_ratio,
            const double density);

    static std::unique_ptr<Material>
    create(const dealii::ParameterHandler &prm);

    MaterialResponse
    respond(const dealii::Tensor<2, 3> &displacement_gradient,
            const MaterialHistory      &history_n) const override;

    unsigned int
    n_history_values() const override;

    bool
    is_linear() const override;

  private:
    dealii::SymmetricTensor<4, 3> tangent_;
  };
} // namespace Signorini

#endif
