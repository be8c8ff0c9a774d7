#ifndef signorini_material_thermal_expansion_h
#define signorini_material_thermal_expansion_h

#include <signorini/input/entry_condition.h>
#include <signorini/material/material.h>

namespace Signorini
{
  /**
   * Any law with isotropic thermal strain e = alpha (T - T_ref), which is free
   * of stress: a logarithmic strain if strains are finite,
   *
   *   F = F_e exp(e),   tau = tau_e(F_e),   H_e = H - e 1 (small strain):
   *
   * what is stored per volume before the deformation is that of the law at F_e.
   *
   * The work of the stress against it since the start,
   *   - int tr(tau) de dV,
   * goes into the body: the "heating" of the energy ledger. It is taken with
   * the mean of both ends of a step, which is exact for Hooke's and Hencky's
   * law. What the temperature itself takes is not looked at, and constants do
   * not depend on it.
   *
   * History: that of the law, then e, tr(tau), and the work, J/m^3.
   */
  class ThermalExpansion : public Material
  {
  public:
    ThermalExpansion(std::unique_ptr<const Material> law,
                     const double                    coefficient,
                     const double                    reference_temperature);

    static void
    declare_parameters(dealii::ParameterHandler &prm);

    /** Which entries are read under which choice. */
    static EntryConditions
    conditions();

    /** The law as it is, or with expansion if the section asks for it.
     * @throws InputError. */
    static std::unique_ptr<Material>
    parse(std::unique_ptr<Material> law, const dealii::ParameterHandler &prm);

    MaterialResponse
    respond(const MaterialPoint            &point,
            const dealii::ArrayView<double> history) const override;

    MaterialResponse
    respond_in_plane_stress(
      MaterialPoint                  &point,
      const dealii::ArrayView<double> history) const override;

    unsigned int
    n_history_values() const override;

    bool
    is_linear() const override
    {
      return false;
    }

    bool
    flows() const override
    {
      return law_->flows();
    }

    bool
    expands() const override
    {
      return true;
    }

    double
    equivalent_plastic_strain(
      const dealii::ArrayView<const double> history) const override
    {
      return law_->equivalent_plastic_strain(history);
    }

  private:
    double
    thermal_strain(const MaterialPoint &point) const;

    // The law is asked about what is left of the deformation.
    MaterialPoint
    elastic_point(const MaterialPoint &point, const double strain) const;

    // What the law answers, and the work against the expansion.
    MaterialResponse
    finish(const MaterialPoint            &point,
           const double                    strain,
           MaterialResponse                response,
           const dealii::ArrayView<double> history) const;

    std::unique_ptr<const Material> law_;
    double                          coefficient_; // alpha, 1/K
    double                          reference_;   // T_ref
  };
} // namespace Signorini

#endif
