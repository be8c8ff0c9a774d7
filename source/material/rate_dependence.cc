#include <signorini/input/input_error.h>
#include <signorini/material/rate_dependence.h>

#include <deal.II/base/parameter_handler.h>

#include <cmath>

namespace Signorini
{
  using namespace dealii;

  void
  RateDependence::declare_parameters(ParameterHandler &prm)
  {
    prm.declare_entry("Rate dependence",
                      "none",
                      Patterns::Selection("none|Johnson-Cook"),
                      "Johnson-Cook: the yield stress is multiplied by "
                      "1 + C ln(rate/rate_0), where the equivalent plastic "
                      "strain grows faster than rate_0. Heating is left out.");
    prm.declare_entry("Rate coefficient",
                      "0.01",
                      Patterns::Double(),
                      "C >= 0 of Johnson-Cook. Unit: 1.");
    prm.declare_entry("Reference rate",
                      "1",
                      Patterns::Double(),
                      "rate_0 > 0 of Johnson-Cook, at which the yield stress "
                      "was measured. Unit: 1/s.");
  }



  EntryConditions
  RateDependence::conditions()
  {
    return {contradiction(read_with({"Rate coefficient", "Reference rate"},
                                    "Rate dependence",
                                    {"Johnson-Cook"}))};
  }



  RateDependence
  RateDependence::parse(const ParameterHandler &prm)
  {
    if (prm.get("Rate dependence") == "none")
      return {};
    const double coefficient    = prm.get_double("Rate coefficient");
    const double reference_rate = prm.get_double("Reference rate");
    if (!(coefficient >= 0.))
      throw InputError("Rate coefficient",
                       "must not be negative, found " +
                         prm.get("Rate coefficient") +
                         ". Metals have 0.001 to 0.05.");
    if (!(reference_rate > 0.))
      throw InputError("Reference rate",
                       "must be greater than zero, in 1/s, found " +
                         prm.get("Reference rate") + ".");
    return {coefficient, reference_rate};
  }



  RateDependence::Factor
  RateDependence::of(const double increment, const double step_size) const
  {
    if (!is_present())
      return {1., 0.};
    Assert(step_size > 0., ExcMessage("A law of rates needs a step size."));
    const double ratio = increment / (step_size * reference_rate_);
    if (!(ratio > 1.))
      return {1., 0.};
    return {1. + coefficient_ * std::log(ratio), coefficient_ / increment};
  }
} // namespace Signorini
