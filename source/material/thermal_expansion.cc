#include <signorini/input/input_error.h>
#include <signorini/material/thermal_expansion.h>

#include <deal.II/base/parameter_handler.h>

#include <cmath>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    // Behind the history of the law.
    enum ThermalHistory
    {
      old_strain,
      old_trace,
      old_work,
      n_thermal_values
    };
  } // namespace



  ThermalExpansion::ThermalExpansion(std::unique_ptr<const Material> law,
                                     const double coefficient,
                                     const double reference_temperature)
    : Material(law->kinematics(), law->density())
    , law_(std::move(law))
    , coefficient_(coefficient)
    , reference_(reference_temperature)
  {}



  void
  ThermalExpansion::declare_parameters(ParameterHandler &prm)
  {
    prm.declare_entry(
      "Thermal expansion",
      "0",
      Patterns::Double(),
      "Coefficient alpha of the thermal strain alpha (T - "
      "Reference temperature), the same in all directions; T is "
      "the Temperature of the body. Unit: 1/K.");
    prm.declare_entry("Reference temperature",
                      "0",
                      Patterns::Double(),
                      "Temperature without thermal strain, in the unit of the "
                      "Temperature of the body. Unit: K or degrees Celsius.");
  }



  EntryConditions
  ThermalExpansion::conditions()
  {
    return {read_if_set({"Reference temperature"}, "Thermal expansion"),
            read_if_set({"Thermal expansion"}, "Temperature")};
  }



  std::unique_ptr<Material>
  ThermalExpansion::parse(std::unique_ptr<Material> law,
                          const ParameterHandler   &prm)
  {
    const double coefficient = prm.get_double("Thermal expansion");
    if (coefficient == 0.)
      return law;
    if (!(std::abs(coefficient) < 0.1))
      throw InputError("Thermal expansion",
                       "found " + prm.get("Thermal expansion") +
                         " 1/K; allowed are magnitudes below 0.1, and metals "
                         "have about 1e-5.");
    return std::make_unique<ThermalExpansion>(
      std::move(law), coefficient, prm.get_double("Reference temperature"));
  }



  unsigned int
  ThermalExpansion::n_history_values() const
  {
    return law_->n_history_values() + n_thermal_values;
  }



  MaterialResponse
  ThermalExpansion::respond(const MaterialPoint    &point,
                            const ArrayView<double> history) const
  {
    const double strain = thermal_strain(point);
    return finish(point,
                  strain,
                  law_->respond(elastic_point(point, strain), history),
                  history);
  }



  MaterialResponse
  ThermalExpansion::respond_in_plane_stress(
    MaterialPoint          &point,
    const ArrayView<double> history) const
  {
    const double           strain  = thermal_strain(point);
    MaterialPoint          elastic = elastic_point(point, strain);
    const MaterialResponse response =
      law_->respond_in_plane_stress(elastic, history);
    const double across  = elastic.gradient[2][2];
    point.gradient[2][2] = kinematics() == Kinematics::small_strain ?
                             across + strain :
                             across * std::exp(strain) + std::expm1(strain);
    return finish(point, strain, response, history);
  }



  double
  ThermalExpansion::thermal_strain(const MaterialPoint &point) const
  {
    return point.step.temperature ?
             coefficient_ * (*point.step.temperature - reference_) :
             point.history_n[law_->n_history_values() + old_strain];
  }



  MaterialPoint
  ThermalExpansion::elastic_point(const MaterialPoint &point,
                                  const double         strain) const
  {
    const bool    is_small = kinematics() == Kinematics::small_strain;
    MaterialPoint elastic  = point;
    for (unsigned int i = 0; i < 3; ++i)
      elastic.gradient[i][i] -= is_small ? strain : std::expm1(strain);
    if (!is_small)
      elastic.gradient *= std::exp(-strain);
    return elastic;
  }



  MaterialResponse
  ThermalExpansion::finish(const MaterialPoint    &point,
                           const double            strain,
                           MaterialResponse        response,
                           const ArrayView<double> history) const
  {
    const unsigned int first = law_->n_history_values();
    const double       sum =
      trace(response.stress) + point.history_n[first + old_trace];
    response.heating_density =
      point.history_n[first + old_work] -
      0.5 * sum * (strain - point.history_n[first + old_strain]);
    history[first + old_strain] = strain;
    history[first + old_trace]  = trace(response.stress);
    history[first + old_work]   = response.heating_density;
    return response;
  }
} // namespace Signorini
