#ifndef signorini_source_material_plastic_history_h
#define signorini_source_material_plastic_history_h

#include <signorini/material/strain_law.h>

#include <deal.II/base/array_view.h>

namespace Signorini
{
  /**
   * How the state of a strain law lies in a history: equivalent plastic strain,
   * plastic work, back stress if there is one. Behind it stands the plastic
   * deformation in the measure of the kinematics.
   */
  namespace PlasticHistory
  {
    unsigned int
    n_state_values(const StrainLaw &law);

    PlasticState
    read_state(const StrainLaw                      &law,
               const dealii::ArrayView<const double> history);

    void
    write_state(const StrainLaw                &law,
                const PlasticState             &state,
                const dealii::ArrayView<double> history);

    /** From the state of a law that is plastic, else zero. */
    double
    equivalent_plastic_strain(const StrainLaw                      &law,
                              const dealii::ArrayView<const double> history);

    /** Six values from @p first on. */
    dealii::SymmetricTensor<2, 3>
    read_symmetric(const dealii::ArrayView<const double> history,
                   const unsigned int                    first);

    void
    write_symmetric(const dealii::SymmetricTensor<2, 3> &tensor,
                    const dealii::ArrayView<double>      history,
                    const unsigned int                   first);
  } // namespace PlasticHistory
} // namespace Signorini

#endif
