#ifndef signorini_source_material_thickness_search_h
#define signorini_source_material_thickness_search_h

#include <signorini/material/strain_law.h>

#include <cmath>

namespace Signorini
{
  /**
   * Newton's method for the strain zz that makes stress zz vanish. The stress
   * grows with the strain: once it had both signs, the root is bracketed, and a
   * step that leaves the bracket bisects it. Before that, steps are bounded.
   */
  class ThicknessSearch
  {
  public:
    /** @param guess the strain to begin with, to which those tried are added */
    explicit ThicknessSearch(const double guess)
      : guess_(std::abs(guess))
    {}

    /** The strain to try next, beyond the first guess. */
    double
    strain() const
    {
      return strain_;
    }

    /**
     * Tells what was found at strain(), and changes it unless this is the end.
     *
     * @param stress    zz, Pa
     * @param magnitude of the whole stress, Pa
     * @param stiffness derivative of the stress to the strain, Pa
     * @throws MaterialFailure when there have been too many.
     */
    bool
    is_done(const double stress,
            const double magnitude,
            const double stiffness);

  private:
    double       guess_;
    double       strain_ = 0.;
    double       lower_;
    double       upper_;
    double       last_stress_;
    bool         has_lower_ = false;
    bool         has_upper_ = false;
    unsigned int n_tries_   = 0;
  };

  /**
   * The response without stress zz: changes the trial strain zz from a guess to
   * the strain that has none.
   */
  StrainResponse
  respond_in_plane_stress(const StrainLaw               &law,
                          dealii::SymmetricTensor<2, 3> &trial_strain,
                          const double                   step_size,
                          const PlasticState            &state_n);
} // namespace Signorini

#endif
