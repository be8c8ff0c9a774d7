#include <signorini/material/elasto_plastic.h>
#include <signorini/material/material.h>

#include <cmath>
#include <limits>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    // The trial stress of a point that only rotates is right to this share of
    // the yield stress; below it nothing flows.
    constexpr double yield_tolerance = 1e-12;

    double
    equivalent_stress(const SymmetricTensor<2, 3> &deviator)
    {
      return std::sqrt(1.5 * (deviator * deviator));
    }
  } // namespace



  // The equation of a step, for the increment of the equivalent plastic strain.
  struct ElastoPlastic::Residual
  {
    struct Value
    {
      double value;
      double slope;
    };

    const ElastoPlastic &law;
    const double         step_size;
    const double         plastic_strain; // a_n
    const double         stress_square;  // 3/2 S:S of the trial stress
    const double         mixed;          // 3/2 S:X_n
    const double         back_square;    // 3/2 X_n:X_n

    Value
    at(const double increment) const
    {
      const auto  &hardening = law.kinematic_hardening_;
      const double w         = 1. + hardening.recovery * increment;
      const double back      = back_square / w;
      // The root of q as a quadratic form in 1/w.
      const double q =
        std::sqrt(std::max(stress_square - (2. * mixed - back) / w, 0.));
      const double q_slope =
        q > 0. ? hardening.recovery * (mixed - back) / (w * w * q) : 0.;
      const auto   yield = law.yield_curve_.at(plastic_strain + increment);
      const auto   rate  = law.rate_dependence_.of(increment, step_size);
      const double shear = 3. * law.constants_.shear;
      return {q - (shear + hardening.modulus / w) * increment -
                yield.stress * rate.value,
              q_slope - shear - hardening.modulus / (w * w) -
                yield.slope * rate.value - yield.stress * rate.slope};
    }
  };



  ElastoPlastic::ElastoPlastic(const ElasticConstants   &constants,
                               const YieldCurve         &yield_curve,
                               const RateDependence     &rate_dependence,
                               const KinematicHardening &kinematic_hardening)
    : elastic_(constants)
    , constants_(constants)
    , yield_curve_(yield_curve)
    , rate_dependence_(rate_dependence)
    , kinematic_hardening_(kinematic_hardening)
  {}



  void
  ElastoPlastic::declare_parameters(ParameterHandler &prm)
  {
    YieldCurve::declare_parameters(prm);
    RateDependence::declare_parameters(prm);
    KinematicHardening::declare_parameters(prm);
  }



  EntryConditions
  ElastoPlastic::conditions()
  {
    EntryConditions list = {contradiction(
      read_with({"Hardening", "Kinematic hardening", "Rate dependence"},
                "Law",
                {"elasto-plastic"}))};
    for (const EntryConditions &part : {YieldCurve::conditions(),
                                        RateDependence::conditions(),
                                        KinematicHardening::conditions()})
      for (const EntryCondition &condition : part)
        {
          list.push_back(contradiction(
            read_with(condition.names, "Law", {"elasto-plastic"})));
          list.push_back(condition);
        }
    return list;
  }



  ElastoPlastic
  ElastoPlastic::parse(const ParameterHandler &prm,
                       const std::string      &base_directory)
  {
    return {ElasticConstants::parse(prm),
            YieldCurve::parse(prm, base_directory),
            RateDependence::parse(prm),
            KinematicHardening::parse(prm)};
  }



  StrainResponse
  ElastoPlastic::respond(const SymmetricTensor<2, 3> &trial_strain,
                         const double                 step_size,
                         const PlasticState          &state_n) const
  {
    // 1. Nothing flows.
    StrainResponse response =
      elastic_.respond(trial_strain, step_size, state_n);
    response.state = state_n;
    if (step_size == 0.)
      return response;

    // 2. Does it?
    const SymmetricTensor<2, 3>  shape    = deviator(response.stress);
    const SymmetricTensor<2, 3> &back     = state_n.back_stress;
    const Residual               residual = {*this,
                                             step_size,
                                             state_n.equivalent_plastic_strain,
                                             1.5 * (shape * shape),
                                             1.5 * (shape * back),
                                             1.5 * (back * back)};
    const auto                   at_rest  = residual.at(0.);
    const double                 yield =
      yield_curve_.at(state_n.equivalent_plastic_strain).stress;
    if (std::isnan(at_rest.value))
      throw MaterialFailure("The trial stress of an elasto-plastic material is "
                            "not a number.");
    if (at_rest.value <= yield_tolerance * yield)
      return response;

    // 3. How much.
    const bool is_linear = yield_curve_.is_linear() &&
                           !rate_dependence_.is_present() &&
                           kinematic_hardening_.recovery == 0.;
    const double increment =
      is_linear ? -at_rest.value / at_rest.slope : solve(residual);
    flow(increment, step_size, shape, state_n, response);
    return response;
  }



  // Newton's method with a bracket. It bisects when a step leaves the bracket,
  // or when the residual did not at least halve.
  double
  ElastoPlastic::solve(const Residual &residual) const
  {
    const double scale =
      std::sqrt(residual.stress_square) + std::sqrt(residual.back_square);
    double lower = 0., upper = scale / (3. * constants_.shear);
    auto   found     = residual.at(lower);
    double increment = std::min(upper, -found.value / found.slope);
    double last      = found.value;
    for (unsigned int iteration = 0; iteration < 200; ++iteration)
      {
        found = residual.at(increment);
        if (std::abs(found.value) <=
            16. * std::numeric_limits<double>::epsilon() * scale)
          return increment;
        (found.value > 0. ? lower : upper) = increment;
        double next = increment - found.value / found.slope;
        if (!(next > lower && next < upper) ||
            std::abs(found.value) > 0.5 * std::abs(last))
          next = 0.5 * (lower + upper);
        // The bracket has closed to neighbouring numbers.
        if (next <= lower || next >= upper)
          return increment;
        last      = found.value;
        increment = next;
      }
    throw MaterialFailure(
      "The return to the yield surface did not converge: the increment of the "
      "equivalent plastic strain lies between " +
      std::to_string(lower) + " and " + std::to_string(upper) + ".");
  }



  void
  ElastoPlastic::flow(const double                 increment,
                      const double                 step_size,
                      const SymmetricTensor<2, 3> &trial_stress,
                      const PlasticState          &state_n,
                      StrainResponse              &response) const
  {
    const double G         = constants_.shear;
    const auto  &kinematic = kinematic_hardening_;
    const double w         = 1. + kinematic.recovery * increment;

    // 1. Direction of flow.
    const SymmetricTensor<2, 3> &back_n   = state_n.back_stress;
    const SymmetricTensor<2, 3>  relative = trial_stress - back_n / w;
    const double                 q        = equivalent_stress(relative);
    const SymmetricTensor<2, 3>  normal   = relative * (std::sqrt(1.5) / q);

    // 2. State.
    PlasticState &state = response.state;
    state.equivalent_plastic_strain += increment;
    response.flows             = true;
    response.plastic_increment = std::sqrt(1.5) * increment * normal;
    state.back_stress =
      (back_n + 2. / 3. * kinematic.modulus * response.plastic_increment) / w;
    const auto rate = rate_dependence_.of(increment, step_size);
    state.plastic_work_density +=
      rate.value * yield_curve_.work(state_n.equivalent_plastic_strain,
                                     state.equivalent_plastic_strain) +
      0.5 * ((back_n + state.back_stress) * response.plastic_increment);

    // 3. Stress and energy.
    const SymmetricTensor<2, 3> drop  = 2. * G * response.plastic_increment;
    const SymmetricTensor<2, 3> shape = trial_stress - drop;
    response.stress -= drop;
    const double pressure = trace(response.stress) / 3.;
    response.energy_density =
      0.5 * pressure * pressure / constants_.bulk + 0.25 / G * (shape * shape);

    // 4. Tangent. The back stress turns the normal when it recovers.
    const auto yield = yield_curve_.at(state.equivalent_plastic_strain);
    const SymmetricTensor<2, 3> recovering =
      kinematic.recovery / (w * w) * back_n;
    const double along     = normal * recovering;
    const double stiffness = 3. * G + kinematic.modulus / (w * w) -
                             std::sqrt(1.5) * along + yield.slope * rate.value +
                             yield.stress * rate.slope;
    const double share = increment / q;
    response.shear     = G * (1. - 3. * G * share);
    response.direction = normal;
    response.factor    = 3. * G * G * (share - 1. / stiffness) * normal -
                      3. * std::sqrt(1.5) * G * G * share / stiffness *
                        (recovering - along * normal);
  }
} // namespace Signorini
