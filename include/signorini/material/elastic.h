#ifndef signorini_material_elastic_h
#define signorini_material_elastic_h

#include <signorini/material/strain_law.h>

namespace dealii
{
  class ParameterHandler;
}

namespace Signorini
{
  /** Isotropic elastic constants. */
  struct ElasticConstants
  {
    double bulk;  // K = E / (3 (1 - 2 nu)), Pa
    double shear; // G = E / (2 (1 + nu)), Pa

    /**
     * @param youngs_modulus E > 0, Pa
     * @param poissons_ratio -1 < nu < 1/2
     */
    static ElasticConstants
    from(const double youngs_modulus, const double poissons_ratio);

    static void
    declare_parameters(dealii::ParameterHandler &prm);

    /** @throws InputError. */
    static ElasticConstants
    parse(const dealii::ParameterHandler &prm);

    /** lambda = K - 2 G / 3, Pa. */
    double
    lame() const
    {
      return bulk - 2. / 3. * shear;
    }
  };

  /**
   * Isotropic linear elasticity,
   *   stress = K tr(strain) 1 + 2 G dev(strain):
   * Hooke's law for small strains, Hencky's for logarithmic ones.
   */
  class Elastic : public StrainLaw
  {
  public:
    explicit Elastic(const ElasticConstants &constants)
      : constants_(constants)
    {}

    StrainResponse
    respond(const dealii::SymmetricTensor<2, 3> &trial_strain,
            const double                         step_size,
            const PlasticState                  &state_n) const override;

    bool
    is_plastic() const override
    {
      return false;
    }

    bool
    has_back_stress() const override
    {
      return false;
    }

  private:
    ElasticConstants constants_;
  };
} // namespace Signorini

#endif
