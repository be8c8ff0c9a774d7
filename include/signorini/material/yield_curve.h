#ifndef signorini_material_yield_curve_h
#define signorini_material_yield_curve_h

#include <signorini/input/entry_condition.h>

#include <string>
#include <vector>

namespace dealii
{
  class ParameterHandler;
}

namespace Signorini
{
  /**
   * The yield stress of a metal that flows slowly, over the equivalent plastic
   * strain a. In large strains both are the logarithmic plastic strain and the
   * Kirchhoff stress.
   *
   *   linear: sigma_y = sigma_0 + H a
   *   table:  straight lines between given points, constant beyond the last
   *   Voce:   sigma_y = sigma_0 + H a + (sigma_s - sigma_0)(1 - exp(-delta a))
   */
  class YieldCurve
  {
  public:
    /** sigma_y and its derivative, Pa. */
    struct Value
    {
      double stress;
      double slope;
    };

    /** A point of a table. */
    struct Entry
    {
      double strain; // 1
      double stress; // Pa
    };

    /** @param yield_stress > 0, Pa; @param modulus >= 0, Pa */
    static YieldCurve
    linear(const double yield_stress, const double modulus);

    /** @throws InputError for a table that is not as described there. */
    static YieldCurve
    table(const std::vector<Entry> &entries);

    /** @param saturation_stress sigma_s, Pa; @param exponent delta > 0 */
    static YieldCurve
    voce(const double yield_stress,
         const double modulus,
         const double saturation_stress,
         const double exponent);

    static void
    declare_parameters(dealii::ParameterHandler &prm);

    /** Which entries are read under which choice. */
    static EntryConditions
    conditions();

    /**
     * @param base_directory to which the name of a file is relative
     * @throws InputError.
     */
    static YieldCurve
    parse(const dealii::ParameterHandler &prm,
          const std::string              &base_directory);

    Value
    at(const double plastic_strain) const;

    /** Integral of sigma_y da, exact. J/m^3 */
    double
    work(const double from, const double to) const;

    /** True if the slope is the same everywhere. */
    bool
    is_linear() const
    {
      return points_.size() == 1 && saturation_ == 0.;
    }

  private:
    // From here on, up to the next point, the curve is straight.
    struct Point
    {
      double strain;
      double stress;
      double slope;
      double work; // from zero to here
    };

    const Point &
    last_before(const double plastic_strain) const;

    std::vector<Point> points_;
    double             saturation_ = 0.; // sigma_s - sigma_0
    double             exponent_   = 1.; // delta
  };
} // namespace Signorini

#endif
