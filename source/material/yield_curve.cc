#include <signorini/input/input_error.h>
#include <signorini/input/number_text.h>
#include <signorini/material/yield_curve.h>

#include <deal.II/base/parameter_handler.h>

#include <algorithm>
#include <cmath>

#include "hardening_table.h"

namespace Signorini
{
  using namespace dealii;

  YieldCurve
  YieldCurve::linear(const double yield_stress, const double modulus)
  {
    YieldCurve curve;
    curve.points_ = {{0., yield_stress, modulus, 0.}};
    return curve;
  }



  YieldCurve
  YieldCurve::table(const std::vector<Entry> &entries)
  {
    check_hardening_table(entries);
    YieldCurve curve;
    for (unsigned int i = 0; i < entries.size(); ++i)
      {
        const auto [strain, stress] = entries[i];
        const bool   is_last        = i + 1 == entries.size();
        const double slope          = is_last ? 0. :
                                                (entries[i + 1].stress - stress) /
                                         (entries[i + 1].strain - strain);
        double       work           = 0.;
        if (i > 0)
          work =
            curve.points_[i - 1].work + 0.5 * (entries[i - 1].stress + stress) *
                                          (strain - entries[i - 1].strain);
        curve.points_.push_back({strain, stress, slope, work});
      }
    return curve;
  }



  YieldCurve
  YieldCurve::voce(const double yield_stress,
                   const double modulus,
                   const double saturation_stress,
                   const double exponent)
  {
    YieldCurve curve  = linear(yield_stress, modulus);
    curve.saturation_ = saturation_stress - yield_stress;
    curve.exponent_   = exponent;
    return curve;
  }



  void
  YieldCurve::declare_parameters(ParameterHandler &prm)
  {
    prm.declare_entry("Hardening",
                      "linear",
                      Patterns::Selection("linear|table|Voce"),
                      "How the yield stress of an elasto-plastic material "
                      "grows with the equivalent plastic strain a. In finite "
                      "strains a is logarithmic, and the stress is Kirchhoff's "
                      "(force per area times the change of volume).");
    prm.declare_entry("Yield stress",
                      "235e6",
                      Patterns::Double(),
                      "sigma_0 > 0, stress at first yield; read with linear "
                      "and Voce hardening. Unit: Pa.");
    prm.declare_entry("Hardening modulus",
                      "0",
                      Patterns::Double(),
                      "H >= 0, the plastic modulus: sigma_y = sigma_0 + H a "
                      "with linear hardening, and the linear part of Voce's. "
                      "Unit: Pa.");
    prm.declare_entry("Hardening table",
                      "",
                      NumberText(),
                      "Points `plastic strain: yield stress', separated by |. "
                      "The strain grows from 0, the stress does not fall. "
                      "Straight lines between, constant beyond the last. Or "
                      "`file NAME' with these two columns. Units: 1 and Pa.");
    prm.declare_entry("Saturation stress",
                      "0",
                      Patterns::Double(),
                      "sigma_s >= sigma_0 of Voce hardening, sigma_y = sigma_0 "
                      "+ H a + (sigma_s - sigma_0)(1 - exp(-delta a)). "
                      "Unit: Pa.");
    prm.declare_entry("Saturation exponent",
                      "0",
                      Patterns::Double(),
                      "delta > 0 of Voce hardening. Unit: 1.");
  }



  EntryConditions
  YieldCurve::conditions()
  {
    return {
      contradiction(read_with({"Yield stress", "Hardening modulus"},
                              "Hardening",
                              {"linear", "Voce"})),
      contradiction(read_with({"Hardening table"}, "Hardening", {"table"})),
      contradiction(read_with({"Saturation stress", "Saturation exponent"},
                              "Hardening",
                              {"Voce"}))};
  }



  YieldCurve
  YieldCurve::parse(const ParameterHandler &prm,
                    const std::string      &base_directory)
  {
    const std::string kind = prm.get("Hardening");
    if (kind == "table")
      return table(
        read_hardening_table(prm.get("Hardening table"), base_directory));

    const double yield_stress = prm.get_double("Yield stress");
    const double modulus      = prm.get_double("Hardening modulus");
    if (!(yield_stress > 0.))
      throw InputError(
        "Yield stress",
        "must be greater than zero, in Pa (mild steel: 235e6), found " +
          prm.get("Yield stress") +
          ". A material that never flows has Law = elastic.");
    if (!(modulus >= 0.))
      throw InputError(
        "Hardening modulus",
        "must not be negative, in Pa, found " + prm.get("Hardening modulus") +
          ". What softens fails in one layer of elements, and the "
          "result would depend on the mesh. Zero is a material "
          "without hardening.");
    if (kind == "linear")
      return linear(yield_stress, modulus);

    const double saturation_stress = prm.get_double("Saturation stress");
    const double exponent          = prm.get_double("Saturation exponent");
    if (!(saturation_stress >= yield_stress))
      throw InputError("Saturation stress",
                       "must not be less than the Yield stress, " +
                         prm.get("Yield stress") + " Pa, found " +
                         prm.get("Saturation stress") + ".");
    if (!(exponent > 0.))
      throw InputError(
        "Saturation exponent",
        "must be greater than zero, found " + prm.get("Saturation exponent") +
          ". With 10, most of the hardening is over at a plastic "
          "strain of 0.3.");
    return voce(yield_stress, modulus, saturation_stress, exponent);
  }



  const YieldCurve::Point &
  YieldCurve::last_before(const double plastic_strain) const
  {
    if (points_.size() == 1)
      return points_[0];
    const auto next = std::upper_bound(points_.begin() + 1,
                                       points_.end(),
                                       plastic_strain,
                                       [](const double a, const Point &point) {
                                         return a < point.strain;
                                       });
    return *(next - 1);
  }



  YieldCurve::Value
  YieldCurve::at(const double plastic_strain) const
  {
    const Point &point = last_before(plastic_strain);
    Value value = {point.stress + point.slope * (plastic_strain - point.strain),
                   point.slope};
    if (saturation_ != 0.)
      {
        const double rest = std::expm1(-exponent_ * plastic_strain);
        value.stress -= saturation_ * rest;
        value.slope += saturation_ * exponent_ * (1. + rest);
      }
    return value;
  }



  double
  YieldCurve::work(const double from, const double to) const
  {
    const Point &first  = last_before(from);
    const Point &last   = last_before(to);
    const auto   within = [](const Point &point, const double strain) {
      const double beyond = strain - point.strain;
      return (point.stress + 0.5 * point.slope * beyond) * beyond;
    };
    double work =
      last.work - first.work + within(last, to) - within(first, from);
    if (saturation_ != 0.)
      work +=
        saturation_ * (to - from +
                       std::exp(-exponent_ * from) *
                         std::expm1(-exponent_ * (to - from)) / exponent_);
    return work;
  }
} // namespace Signorini
