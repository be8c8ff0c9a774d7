#include <signorini/contact/friction_law.h>
#include <signorini/input_error.h>
#include <signorini/named_list.h>
#include <signorini/silenced_errors.h>

#include <deal.II/base/parameter_handler.h>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    double
    parse_not_negative(const std::string &text, const std::string &entry)
    {
      const double value = parse_number(text, entry);
      if (!(value >= 0.))
        throw InputError(entry + ": found " + text +
                         ", but it must not be negative.");
      return value;
    }

    std::shared_ptr<FunctionParser<1>>
    parse_rate_function(const std::string &text,
                        const Constants   &constants,
                        const std::string &entry)
    {
      auto                 function = std::make_shared<FunctionParser<1>>(1);
      const SilencedErrors silence;
      try
        {
          function->initialize("v", text, constants);
          function->value(Point<1>(0.));
        }
      catch (const std::exception &)
        {
          throw InputError(entry + ": cannot read \"" + text +
                           "\". Write a number, or an expression in v, the "
                           "slip rate in m/s, such as 0.2 + 0.1*exp(-v/0.5).");
        }
      return function;
    }
  } // namespace



  void
  FrictionLaw::declare_parameters(const bool in_pair, ParameterHandler &prm)
  {
    const auto declare = [&](const std::string &name,
                             const std::string &value,
                             const std::string &text) {
      prm.declare_entry(name,
                        in_pair ? "" : value,
                        Patterns::Anything(),
                        in_pair ?
                          "As in Contact, for this pair. Empty: as there." :
                          text);
    };
    declare("Friction coefficient",
            "0",
            "Coulomb's mu: friction is at most mu times the contact pressure. "
            "The static one, if there are two. Unit: 1.");
    declare("Kinetic friction coefficient",
            "",
            "mu of a contact that slipped in the step before. A function of v, "
            "the slip rate in m/s, or a number. Empty: the same as Friction "
            "coefficient. Unit: 1.");
    declare("Shear stress limit",
            "",
            "tau_max: friction is also at most this stress (Tresca's law where "
            "mu p is greater). Empty: none. Unit: Pa.");
  }



  FrictionLaw
  FrictionLaw::parse(
    const Constants                                       &constants,
    const std::function<std::string(const std::string &)> &get,
    const std::function<std::string(const std::string &)> &path)
  {
    const auto parse_entry = [&](const std::string &name) {
      return parse_not_negative(get(name), path(name));
    };
    FrictionLaw law;
    law.static_coefficient_ = parse_entry("Friction coefficient");
    if (!get("Shear stress limit").empty())
      law.largest_shear_stress_ = parse_entry("Shear stress limit");

    const std::string kinetic = get("Kinetic friction coefficient");
    if (kinetic.empty())
      return law;
    const std::string entry = path("Kinetic friction coefficient");
    if (law.static_coefficient_ == 0.)
      throw InputError(entry + ": found " + kinetic +
                       ", but the Friction coefficient is zero. Give that of "
                       "a contact at rest, too.");
    try
      {
        law.kinetic_coefficient_ = parse_number(kinetic, entry);
      }
    catch (const InputError &)
      {
        law.coefficient_of_rate_ =
          parse_rate_function(kinetic, constants, entry);
      }
    if (law.kinetic_coefficient_ && *law.kinetic_coefficient_ < 0.)
      throw InputError(entry + ": found " + kinetic +
                       ", but it must not be negative.");
    return law;
  }



  double
  FrictionLaw::coefficient(const bool sticks, const double slip_rate) const
  {
    if (sticks || is_constant())
      return static_coefficient_;
    if (kinetic_coefficient_)
      return *kinetic_coefficient_;
    return std::max(0., coefficient_of_rate_->value(Point<1>(slip_rate)));
  }
} // namespace Signorini
