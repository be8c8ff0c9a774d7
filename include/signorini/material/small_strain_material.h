#ifndef signorini_material_small_strain_material_h
#define signorini_material_small_strain_material_h

#include <signorini/material/material.h>
#include <signorini/material/strain_law.h>

namespace Signorini
{
  /**
   * A strain law as it stands: the strain is the symmetric part of the
   * displacement gradient, the elastic part of it what is not plastic.
   */
  class SmallStrainMaterial : public Material
  {
  public:
    SmallStrainMaterial(std::unique_ptr<const StrainLaw> law,
                        const double                     density);

    MaterialResponse
    respond(const dealii::Tensor<2, 3>           &displacement_gradient,
            const double                          step_size,
            const dealii::ArrayView<const double> history_n,
            const dealii::ArrayView<double>       history) const override;

    MaterialResponse
    respond_in_plane_stress(
      dealii::Tensor<2, 3>                 &displacement_gradient,
      const double                          step_size,
      const dealii::ArrayView<const double> history_n,
      const dealii::ArrayView<double>       history) const override;

    unsigned int
    n_history_values() const override;

    bool
    is_linear() const override
    {
      return !law_->is_plastic();
    }

    bool
    flows() const override
    {
      return law_->is_plastic();
    }

    double
    equivalent_plastic_strain(
      const dealii::ArrayView<const double> history) const override;

  private:
    dealii::SymmetricTensor<2, 3>
    plastic_strain(const dealii::ArrayView<const double> history) const;

    MaterialResponse
    finish(const dealii::SymmetricTensor<2, 3> &plastic_strain_n,
           const StrainResponse                &response,
           const dealii::ArrayView<double>      history) const;

    std::unique_ptr<const StrainLaw> law_;
  };
} // namespace Signorini

#endif
