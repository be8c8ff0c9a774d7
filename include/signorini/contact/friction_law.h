#ifndef signorini_contact_friction_law_h
#define signorini_contact_friction_law_h

#include <signorini/contact/pair_entries.h>
#include <signorini/input/entry_condition.h>
#include <signorini/input/formula.h>

#include <limits>
#include <memory>
#include <optional>
#include <string>

namespace dealii
{
  class ParameterHandler;
}

namespace Signorini
{
  /**
   * Coulomb's law with a bound on the shear stress,
   *
   *   |sigma_T| <= min(mu p, tau_max).
   *
   * mu is the static coefficient mu_s at a contact that sticks or just closed,
   * and at one that slips the kinetic one mu_k, which may depend on the slip
   * rate. With a slip weakening length d it goes over from the one to the other
   * with the way s of the slip, mu_k + (mu_s - mu_k) max(0, 1 - s/d).
   */
  class FrictionLaw
  {
  public:
    /** No friction. */
    FrictionLaw() = default;

    /**
     * Declares its entries in the section that @p prm is in.
     * @param in_pair of one pair: empty entries are those of all pairs
     */
    static void
    declare_parameters(const bool in_pair, dealii::ParameterHandler &prm);

    /** Which entries are read under which choice. */
    static EntryConditions
    conditions();

    /** @throws InputError. */
    static FrictionLaw
    parse(const Constants &constants, const PairEntries &entries);

    bool
    is_frictionless() const
    {
      return static_coefficient_ == 0. && !kinetic_coefficient_ &&
             !coefficient_of_rate_;
    }

    /** mu of a contact that sticks, or of one that slips at a rate (m/s) and
     * has done so over a way (m). */
    double
    coefficient(const bool   sticks,
                const double slip_rate,
                const double slip_way) const;

    /** True if mu is the same in every state. */
    bool
    is_constant() const
    {
      return !kinetic_coefficient_ && !coefficient_of_rate_;
    }

    /** tau_max, Pa; infinite if there is none. */
    double
    largest_shear_stress() const
    {
      return largest_shear_stress_;
    }

  private:
    double                static_coefficient_ = 0.;
    std::optional<double> kinetic_coefficient_;

    std::shared_ptr<const Formula> coefficient_of_rate_; // mu(v)

    double weakening_length_ = 0.; // m

    double largest_shear_stress_ = std::numeric_limits<double>::infinity();
  };
} // namespace Signorini

#endif
