#ifndef signorini_material_strain_law_material_h
#define signorini_material_strain_law_material_h

#include <signorini/material/material.h>
#include <signorini/material/strain_law.h>

namespace Signorini
{
  /**
   * A strain law put between displacement gradients and stresses. How strains
   * are measured is said by the classes derived from it.
   *
   * History: the state of the law, and behind it the plastic deformation.
   */
  class StrainLawMaterial : public Material
  {
  public:
    unsigned int
    n_history_values() const final;

    bool
    is_linear() const final
    {
      return kinematics() == Kinematics::small_strain && !law_->is_plastic();
    }

    bool
    flows() const final
    {
      return law_->is_plastic();
    }

    double
    equivalent_plastic_strain(
      const dealii::ArrayView<const double> history) const final;

  protected:
    /** @param n_plastic_values numbers of the plastic deformation */
    StrainLawMaterial(std::unique_ptr<const StrainLaw> law,
                      const Kinematics                 kinematics,
                      const double                     density,
                      const unsigned int               n_plastic_values);

    const StrainLaw &
    law() const
    {
      return *law_;
    }

    /** Where the plastic deformation begins in a history. */
    unsigned int
    n_state_values() const;

  private:
    std::unique_ptr<const StrainLaw> law_;
    unsigned int                     n_plastic_values_;
  };
} // namespace Signorini

#endif
