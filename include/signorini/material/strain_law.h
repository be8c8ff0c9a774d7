#ifndef signorini_material_strain_law_h
#define signorini_material_strain_law_h

#include <deal.II/base/symmetric_tensor.h>

namespace Signorini
{
  /** What a law of plasticity remembers beside the plastic strain. */
  struct PlasticState
  {
    double equivalent_plastic_strain = 0.; // 1
    double plastic_work_density      = 0.; // J/m^3

    dealii::SymmetricTensor<2, 3> back_stress; // deviatoric, Pa
  };

  /** What a strain law answers. */
  struct StrainResponse
  {
    dealii::SymmetricTensor<2, 3> stress; // Pa

    // d stress / d strain = bulk 1 x 1 + 2 shear I_dev
    //                       + direction x factor + factor x direction,
    // consistent with the step and symmetric. Pa
    double                        bulk;
    double                        shear;
    dealii::SymmetricTensor<2, 3> direction;
    dealii::SymmetricTensor<2, 3> factor;

    double energy_density; // of the elastic strain, J/m^3

    bool                          flows = false;
    dealii::SymmetricTensor<2, 3> plastic_increment; // of the strain, 1
    PlasticState                  state;
  };

  /**
   * An isotropic law in the terms of small strains, from which follow a law for
   * small strains (SmallStrainMaterial) and one for finite strains in
   * logarithmic strains (LogarithmicMaterial). Since it is isotropic, its
   * tensors may be given in the components of any frame.
   */
  class StrainLaw
  {
  public:
    virtual ~StrainLaw() = default;

    /**
     * @param trial_strain the elastic strain if nothing flows in this step
     * @param step_size    s, read by laws that depend on the rate; 0: at once,
     *                     so that nothing flows
     * @throws MaterialFailure when there is no answer.
     */
    virtual StrainResponse
    respond(const dealii::SymmetricTensor<2, 3> &trial_strain,
            const double                         step_size,
            const PlasticState                  &state_n) const = 0;

    /** False if the response neither flows nor reads the state. */
    virtual bool
    is_plastic() const = 0;

    /** True if the back stress is used. */
    virtual bool
    has_back_stress() const = 0;
  };
} // namespace Signorini

#endif
