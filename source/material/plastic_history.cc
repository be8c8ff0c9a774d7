#include "plastic_history.h"

namespace Signorini
{
  namespace PlasticHistory
  {
    using namespace dealii;

    unsigned int
    n_state_values(const StrainLaw &law)
    {
      return (law.is_plastic() ? 2 : 0) + (law.has_back_stress() ? 6 : 0);
    }



    PlasticState
    read_state(const StrainLaw &law, const ArrayView<const double> history)
    {
      PlasticState state;
      if (law.is_plastic())
        {
          state.equivalent_plastic_strain = history[0];
          state.plastic_work_density      = history[1];
        }
      if (law.has_back_stress())
        state.back_stress = read_symmetric(history, 2);
      return state;
    }



    void
    write_state(const StrainLaw        &law,
                const PlasticState     &state,
                const ArrayView<double> history)
    {
      if (law.is_plastic())
        {
          history[0] = state.equivalent_plastic_strain;
          history[1] = state.plastic_work_density;
        }
      if (law.has_back_stress())
        write_symmetric(state.back_stress, history, 2);
    }



    double
    equivalent_plastic_strain(const StrainLaw              &law,
                              const ArrayView<const double> history)
    {
      return law.is_plastic() ? history[0] : 0.;
    }



    SymmetricTensor<2, 3>
    read_symmetric(const ArrayView<const double> history,
                   const unsigned int            first)
    {
      SymmetricTensor<2, 3> tensor;
      for (unsigned int i = 0; i < 6; ++i)
        tensor.access_raw_entry(i) = history[first + i];
      return tensor;
    }



    void
    write_symmetric(const SymmetricTensor<2, 3> &tensor,
                    const ArrayView<double>      history,
                    const unsigned int           first)
    {
      for (unsigned int i = 0; i < 6; ++i)
        history[first + i] = tensor.access_raw_entry(i);
    }
  } // namespace PlasticHistory
} // namespace Signorini
