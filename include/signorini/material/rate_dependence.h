#ifndef signorini_material_rate_dependence_h
#define signorini_material_rate_dependence_h

#include <signorini/input/entry_condition.h>

namespace dealii
{
  class ParameterHandler;
}

namespace Signorini
{
  /**
   * How the yield stress grows with the rate of the equivalent plastic strain,
   * as a factor on the YieldCurve. Johnson and Cook without temperature:
   *   1 + C ln(rate / rate_0), and 1 for rates up to rate_0.
   */
  class RateDependence
  {
  public:
    /** No dependence. */
    RateDependence() = default;

    /** @param coefficient C >= 0; @param reference_rate rate_0 > 0, 1/s */
    RateDependence(const double coefficient, const double reference_rate)
      : coefficient_(coefficient)
      , reference_rate_(reference_rate)
    {}

    static void
    declare_parameters(dealii::ParameterHandler &prm);

    /** Which entries are read under which choice. */
    static EntryConditions
    conditions();

    /** @throws InputError. */
    static RateDependence
    parse(const dealii::ParameterHandler &prm);

    bool
    is_present() const
    {
      return coefficient_ > 0.;
    }

    /** The factor, and its derivative to the increment. */
    struct Factor
    {
      double value;
      double slope;
    };

    /**
     * The factor of an increment of plastic strain within a step.
     * @param step_size s; greater than zero if the dependence is present
     */
    Factor
    of(const double increment, const double step_size) const;

  private:
    double coefficient_    = 0.; // C
    double reference_rate_ = 1.; // 1/s
  };
} // namespace Signorini

#endif
