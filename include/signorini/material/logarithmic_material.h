#ifndef signorini_material_logarithmic_material_h
#define signorini_material_logarithmic_material_h

#include <signorini/material/principal_frame.h>
#include <signorini/material/strain_law_material.h>

namespace Signorini
{
  /**
   * A strain law made one for finite strains, in elastic logarithmic strains.
   *
   * F = F_e F_p, and within a step, with F_p of its start,
   *
   *   F_e,trial = F F_p,n^-1 = R U,   E_trial = ln U.
   *
   * The law answers to E_trial with the (Mandel) stress M, the increment of the
   * plastic strain and so the elastic strain E = E_trial - dE_p, and
   *
   *   tau = R M R^T,   F_e = R exp(E),   F_p^-1 = F^-1 F_e.
   *
   * Where dE_p has the axes of E_trial, as it has without back stress, this is
   * the exponential map F_p = exp(dE_p) F_p,n without plastic spin; else it
   * differs from it by the product of both strains, but it leaves a state
   * whose stress is again tau: a later rotation neither changes the stress nor
   * lets anything flow. det F_p = 1 always.
   *
   * The back stress is measured in the intermediate configuration and turns
   * with R.
   *
   * The tangent is exact where the stress has the axes of E_trial, and then
   * symmetric. Else it is the symmetric part of the exact one; what is missing
   * is of the size of the stress times E_trial.
   *
   * In the axes of E_trial, with Delta = e_a - e_b, the rates follow from
   *   dE_ab = Delta/sinh(Delta) d_ab,
   *   (dR R^T)_ab = w_ab - tanh(Delta/2) d_ab.
   *
   * The plastic deformation in the history is F_p^-1 - 1, by rows.
   *
   * [EterovicBathe1990; Simo1992; DeSouzaNetoPericOwen2008, ch. 14; Hill's
   * principal axes for the rates]
   */
  class LogarithmicMaterial : public StrainLawMaterial
  {
  public:
    LogarithmicMaterial(std::unique_ptr<const StrainLaw> law,
                        const double                     density);

    MaterialResponse
    respond(const MaterialPoint            &point,
            const dealii::ArrayView<double> history) const override;

    MaterialResponse
    respond_in_plane_stress(
      MaterialPoint                  &point,
      const dealii::ArrayView<double> history) const override;

  private:
    // What a step begins with.
    struct Trial
    {
      dealii::Tensor<2, 3>          plastic; // F_p,n^-1 - 1
      PrincipalFrame                frame;   // of F_e,trial
      dealii::SymmetricTensor<2, 3> strain;  // E_trial in this frame
      PlasticState                  state;   // in this frame
    };

    Trial
    trial(const dealii::Tensor<2, 3>           &displacement_gradient,
          const dealii::ArrayView<const double> history_n) const;

    MaterialResponse
    finish(const Trial                          &trial,
           const StrainResponse                 &response,
           const dealii::ArrayView<const double> history_n,
           const dealii::ArrayView<double>       history) const;
  };
} // namespace Signorini

#endif
