#include <signorini/material/strain_law_material.h>

#include "plastic_history.h"

namespace Signorini
{
  using namespace dealii;

  StrainLawMaterial::StrainLawMaterial(std::unique_ptr<const StrainLaw> law,
                                       const Kinematics   kinematics,
                                       const double       density,
                                       const unsigned int n_plastic_values)
    : Material(kinematics, density)
    , law_(std::move(law))
    , n_plastic_values_(law_->is_plastic() ? n_plastic_values : 0)
  {}



  unsigned int
  StrainLawMaterial::n_state_values() const
  {
    return PlasticHistory::n_state_values(*law_);
  }



  unsigned int
  StrainLawMaterial::n_history_values() const
  {
    return n_state_values() + n_plastic_values_;
  }



  double
  StrainLawMaterial::equivalent_plastic_strain(
    const ArrayView<const double> history) const
  {
    return PlasticHistory::equivalent_plastic_strain(*law_, history);
  }
} // namespace Signorini
