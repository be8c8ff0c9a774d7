#include <signorini/contact/friction_law.h>
#include <signorini/input/input_error.h>
#include <signorini/input/number_text.h>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    // Tried at rest and at a slow pace; how fast it gets nobody knows yet.
    Formula
    parse_rate_function(const std::string &text,
                        const Constants   &constants,
                        const std::string &entry)
    {
      const Formula formula(text, {"v"}, constants, entry);
      for (const double rate : {0., 1e-9, 1e-6, 1e-3})
        if (formula.value({rate}) < 0.)
          throw InputError(entry,
                           "found " + text + ", but it must not be negative.");
      return formula;
    }
  } // namespace



  void
  FrictionLaw::declare_parameters(const bool in_pair, ParameterHandler &prm)
  {
    const auto declare = [&](const std::string           &name,
                             const std::string           &value,
                             const std::string           &text,
                             const Patterns::PatternBase &pattern) {
      declare_pair_entry(name, value, text, in_pair, prm, pattern);
    };
    declare("Friction coefficient",
            "0",
            "Coulomb's mu: friction is at most mu times the contact pressure. "
            "The static one, if there are two. Unit: 1.",
            NumberText());
    declare("Kinetic friction coefficient",
            "",
            "mu of a contact that slipped in the step before. A function of v, "
            "the slip rate in m/s, or a number. Empty: the same as Friction "
            "coefficient. Where it drops at once, the nodes of a contact break "
            "loose one after another, sooner than the mean of their forces "
            "says; with a Slip weakening length they go together. Unit: 1.",
            Patterns::Anything());
    declare("Slip weakening length",
            "0",
            "Way of slip over which the coefficient falls from the static to "
            "the kinetic one, in proportion; 0: at once. Unit: m.",
            NumberText());
    declare("Shear stress limit",
            "",
            "tau_max: friction is also at most this stress (Tresca's law where "
            "mu p is greater). Empty: none. Unit: Pa.",
            NumberText());
  }



  EntryConditions
  FrictionLaw::conditions()
  {
    return {read_if_set({"Shear stress limit"}, "Friction coefficient"),
            read_if_set({"Slip weakening length"},
                        "Kinetic friction coefficient")};
  }



  FrictionLaw
  FrictionLaw::parse(const Constants &constants, const PairEntries &entries)
  {
    const auto &[get, path] = entries;
    FrictionLaw law;
    law.static_coefficient_ =
      parse_not_negative(entries, "Friction coefficient");
    if (!get("Shear stress limit").empty())
      law.largest_shear_stress_ =
        parse_not_negative(entries, "Shear stress limit");

    const std::string kinetic = get("Kinetic friction coefficient");
    if (kinetic.empty())
      return law;
    law.weakening_length_ =
      parse_not_negative(entries, "Slip weakening length");
    const std::string entry = path("Kinetic friction coefficient");
    if (law.static_coefficient_ == 0.)
      throw InputError(entry,
                       "found " + kinetic +
                         ", but the Friction coefficient is zero. Give that of "
                         "a contact at rest, too.");
    const Formula formula = parse_rate_function(kinetic, constants, entry);
    if (formula.depends_on("v"))
      law.coefficient_of_rate_ = std::make_shared<const Formula>(formula);
    else
      law.kinetic_coefficient_ = formula.value({0.});
    return law;
  }



  double
  FrictionLaw::coefficient(const bool   sticks,
                           const double slip_rate,
                           const double slip_way) const
  {
    if (sticks || is_constant())
      return static_coefficient_;
    const double kinetic =
      kinetic_coefficient_ ?
        *kinetic_coefficient_ :
        std::max(0., coefficient_of_rate_->value({slip_rate}));
    const double left = weakening_length_ > 0. ?
                          std::max(0., 1. - slip_way / weakening_length_) :
                          0.;
    return kinetic + left * (static_coefficient_ - kinetic);
  }
} // namespace Signorini
