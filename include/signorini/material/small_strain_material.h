#ifndef signorini_material_small_strain_material_h
#define signorini_material_small_strain_material_h

#include <signorini/material/strain_law_material.h>

namespace Signorini
{
  /**
   * A strain law as it stands: the strain is the symmetric part of the
   * displacement gradient, the elastic part of it what is not plastic.
   */
  class SmallStrainMaterial : public StrainLawMaterial
  {
  public:
    SmallStrainMaterial(std::unique_ptr<const StrainLaw> law,
                        const double                     density);

    MaterialResponse
    respond(const MaterialPoint            &point,
            const dealii::ArrayView<double> history) const override;

    MaterialResponse
    respond_in_plane_stress(
      MaterialPoint                  &point,
      const dealii::ArrayView<double> history) const override;

  private:
    dealii::SymmetricTensor<2, 3>
    plastic_strain(const dealii::ArrayView<const double> history) const;

    MaterialResponse
    finish(const dealii::SymmetricTensor<2, 3> &plastic_strain_n,
           const StrainResponse                &response,
           const dealii::ArrayView<double>      history) const;
  };
} // namespace Signorini

#endif
