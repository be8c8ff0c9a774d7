#include <signorini/material/logarithmic_material.h>

#include <algorithm>
#include <cmath>

#include "plastic_history.h"
#include "spatial_tangent.h"
#include "thickness_search.h"
#include "volume_ratio.h"

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    // F_p^-1 - 1
    Tensor<2, 3>
    read_plastic(const ArrayView<const double> history,
                 const unsigned int            first)
    {
      Tensor<2, 3> inverse;
      for (unsigned int i = 0; i < 9; ++i)
        inverse[i / 3][i % 3] = history[first + i];
      return inverse;
    }

    // exp(-E_trial) exp(E) - 1 in the frame of E_trial.
    Tensor<2, 3>
    update_of_plastic(const PrincipalFrame        &frame,
                      const SymmetricTensor<2, 3> &increment)
    {
      Tensor<2, 3> update;
      const bool   is_coaxial =
        increment[0][1] == 0. && increment[0][2] == 0. && increment[1][2] == 0.;
      if (is_coaxial)
        {
          for (unsigned int a = 0; a < 3; ++a)
            update[a][a] = std::expm1(-increment[a][a]);
          return update;
        }
      SymmetricTensor<2, 3> elastic = -increment;
      for (unsigned int a = 0; a < 3; ++a)
        elastic[a][a] += frame.log_strain[a];
      const auto [values, axes] = decompose(elastic, frame.is_planar);
      // exp(E) - 1
      for (unsigned int c = 0; c < 3; ++c)
        {
          const double growth = std::expm1(values[c]);
          for (unsigned int a = 0; a < 3; ++a)
            for (unsigned int b = 0; b < 3; ++b)
              update[a][b] += growth * axes[a][c] * axes[b][c];
        }
      for (unsigned int a = 0; a < 3; ++a)
        {
          update[a] /= frame.stretch[a];
          update[a][a] += std::expm1(-frame.log_strain[a]);
        }
      return update;
    }

    void
    write_plastic(const Tensor<2, 3>     &inverse,
                  const ArrayView<double> history,
                  const unsigned int      first)
    {
      for (unsigned int i = 0; i < 9; ++i)
        history[first + i] = inverse[i / 3][i % 3];
    }
  } // namespace



  LogarithmicMaterial::LogarithmicMaterial(std::unique_ptr<const StrainLaw> law,
                                           const double density)
    : StrainLawMaterial(std::move(law), Kinematics::finite_strain, density, 9)
  {}



  MaterialResponse
  LogarithmicMaterial::respond(const MaterialPoint    &point,
                               const ArrayView<double> history) const
  {
    const Trial begin = trial(point.gradient, point.history_n);
    return finish(begin,
                  law().respond(begin.strain, point.step.size, begin.state),
                  point.history_n,
                  history);
  }



  // Across the sheet lies a principal axis, to which everything else is fixed:
  // only the law has to be asked again.
  MaterialResponse
  LogarithmicMaterial::respond_in_plane_stress(
    MaterialPoint          &point,
    const ArrayView<double> history) const
  {
    Trial begin = trial(point.gradient, point.history_n);
    Assert(begin.frame.is_planar,
           ExcMessage("A sheet has no shear across it."));
    const StrainResponse response = Signorini::respond_in_plane_stress(
      law(), begin.strain, point.step.size, begin.state);

    const double strain       = begin.strain[2][2];
    begin.frame.log_strain[2] = strain;
    begin.frame.stretch[2]    = std::exp(strain);
    // 1 + H_zz = F_e F_p
    const double plastic = begin.plastic[2][2];
    point.gradient[2][2] = (std::expm1(strain) - plastic) / (1. + plastic);
    return finish(begin, response, point.history_n, history);
  }



  LogarithmicMaterial::Trial
  LogarithmicMaterial::trial(const Tensor<2, 3> &displacement_gradient,
                             const ArrayView<const double> history_n) const
  {
    volume_ratio_minus_one(displacement_gradient); // refuses what is inverted
    Trial        result;
    Tensor<2, 3> elastic = displacement_gradient; // F_e,trial - 1
    if (law().is_plastic())
      {
        result.plastic = read_plastic(history_n, n_state_values());
        elastic += result.plastic + displacement_gradient * result.plastic;
      }
    result.frame = PrincipalFrame::of(elastic);
    for (unsigned int a = 0; a < 3; ++a)
      result.strain[a][a] = result.frame.log_strain[a];
    result.state = PlasticHistory::read_state(law(), history_n);
    if (law().has_back_stress())
      result.state.back_stress =
        into_axes(result.state.back_stress, result.frame.material_axes);
    return result;
  }



  MaterialResponse
  LogarithmicMaterial::finish(const Trial                  &trial,
                              const StrainResponse         &response,
                              const ArrayView<const double> history_n,
                              const ArrayView<double>       history) const
  {
    const PrincipalFrame &frame = trial.frame;
    if (response.flows)
      {
        const Tensor<2, 3> &axes = frame.material_axes;
        const Tensor<2, 3>  update =
          axes * update_of_plastic(frame, response.plastic_increment) *
          transpose(axes);
        write_plastic(trial.plastic + update + trial.plastic * update,
                      history,
                      n_state_values());
        PlasticState state = response.state;
        if (law().has_back_stress())
          state.back_stress = into_axes(state.back_stress, transpose(axes));
        PlasticHistory::write_state(law(), state, history);
      }
    else // the old one, to the digit
      std::copy_n(history_n.begin(), n_history_values(), history.begin());
    return push_forward(frame, response);
  }
} // namespace Signorini
