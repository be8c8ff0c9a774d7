#ifndef signorini_material_elasto_plastic_h
#define signorini_material_elasto_plastic_h

#include <signorini/input/entry_condition.h>
#include <signorini/material/elastic.h>
#include <signorini/material/kinematic_hardening.h>
#include <signorini/material/rate_dependence.h>
#include <signorini/material/yield_curve.h>

namespace Signorini
{
  /**
   * Plasticity of metals (J2, von Mises) with associated flow,
   *
   *   q(dev(stress) - X) <= sigma_y(a) R(da/dt),   q(S) = sqrt(3/2) |S|,
   *   dE_p = sqrt(3/2) N da,   N = (dev(stress) - X) / |dev(stress) - X|,
   *
   * with the yield stress sigma_y and the factor R of a YieldCurve and a
   * RateDependence, and the back stress X of KinematicHardening. The step is
   * taken by backward Euler; what remains is one equation for the increment
   * of a, whose left side falls steadily:
   *
   *   q(S_trial - X_n / w) - (3 G + H_k / w) da = sigma_y(a_n + da) R,
   *   w = 1 + gamma da.
   *
   * Without rates and recovery and with linear hardening it is solved in closed
   * form, else by Newton's method, which bisects where it leaves the bracket.
   *
   * The tangent is consistent with the step. That of Armstrong and Frederick is
   * not symmetric where the direction of flow turns; the symmetric part is
   * given.
   *
   * The plastic work is exact as long as the direction of flow keeps within the
   * step (and X is linear in it), and of second order otherwise:
   *   R int sigma_y da + (X_n + X)/2 : (E_p - E_p,n).
   *
   * [SimoHughes1998, boxes 3.1 and 3.2; DeSouzaNetoPericOwen2008, sec. 7.6]
   */
  class ElastoPlastic : public StrainLaw
  {
  public:
    ElastoPlastic(const ElasticConstants   &constants,
                  const YieldCurve         &yield_curve,
                  const RateDependence     &rate_dependence     = {},
                  const KinematicHardening &kinematic_hardening = {});

    static void
    declare_parameters(dealii::ParameterHandler &prm);

    /** Which entries are read under which choice. */
    static EntryConditions
    conditions();

    /**
     * @param base_directory to which names of files are relative
     * @throws InputError.
     */
    static ElastoPlastic
    parse(const dealii::ParameterHandler &prm,
          const std::string              &base_directory);

    StrainResponse
    respond(const dealii::SymmetricTensor<2, 3> &trial_strain,
            const double                         step_size,
            const PlasticState                  &state_n) const override;

    bool
    is_plastic() const override
    {
      return true;
    }

    bool
    has_back_stress() const override
    {
      return kinematic_hardening_.is_present();
    }

  private:
    struct Residual;

    double
    solve(const Residual &residual) const;

    void
    flow(const double                         increment,
         const double                         step_size,
         const dealii::SymmetricTensor<2, 3> &trial_stress,
         const PlasticState                  &state_n,
         StrainResponse                      &response) const;

    Elastic            elastic_;
    ElasticConstants   constants_;
    YieldCurve         yield_curve_;
    RateDependence     rate_dependence_;
    KinematicHardening kinematic_hardening_;
  };
} // namespace Signorini

#endif
