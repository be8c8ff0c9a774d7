#include <signorini/input/input_error.h>
#include <signorini/time/generalized_alpha.h>

#include <cmath>
#include <sstream>

namespace Signorini
{
  namespace
  {
    // Numbers typed with few digits may miss a bound by their rounding.
    constexpr double rounding = 1e-12;

    void
    require(const bool         condition,
            const std::string &entry,
            const std::string &rule,
            const std::string &found,
            const std::string &consequence)
    {
      if (condition)
        return;
      throw InputError("Time / " + entry,
                       rule + " is required, found " + found + ". Otherwise " +
                         consequence +
                         ". Mend the numbers in the section Time, or choose "
                         "another Scheme.");
    }

    std::string
    number(const char *name, const double value)
    {
      std::ostringstream text;
      text << name << " = " << value;
      return text.str();
    }

    // alpha_B and alpha_H alone fix a second-order method with the largest
    // dissipation of high frequencies.
    GeneralizedAlpha
    optimal(const double alpha_B, const double alpha_H)
    {
      const double difference = alpha_H - alpha_B;
      return {alpha_B,
              alpha_H,
              0.25 * (1. + difference) * (1. + difference),
              0.5 + difference};
    }
  } // namespace



  bool
  GeneralizedAlpha::is_second_order() const
  {
    return std::abs(gamma - (0.5 - alpha_B + alpha_H)) < 1e-10;
  }



  GeneralizedAlpha
  trapezoidal_rule()
  {
    return {0., 0., 0.25, 0.5};
  }



  GeneralizedAlpha
  midpoint_rule()
  {
    return {0.5, 0.5, 0.25, 0.5};
  }



  GeneralizedAlpha
  newmark(const double beta, const double gamma)
  {
    return generalized_alpha(0., 0., beta, gamma);
  }



  GeneralizedAlpha
  hilber_hughes_taylor(const double alpha_H)
  {
    require(alpha_H >= 0. && alpha_H <= 0.5 + rounding,
            "alpha_H",
            "0 <= alpha_H <= 1/2",
            number("alpha_H", alpha_H),
            "the scheme of Hilber, Hughes and Taylor is unstable");
    return optimal(0., alpha_H);
  }



  GeneralizedAlpha
  chung_hulbert(const double spectral_radius)
  {
    require(spectral_radius >= 0. && spectral_radius <= 1.,
            "Spectral radius",
            "0 <= Spectral radius <= 1",
            number("Spectral radius", spectral_radius),
            "high frequencies grow from step to step");
    const double rho = spectral_radius;
    return optimal((2. * rho - 1.) / (rho + 1.), rho / (rho + 1.));
  }



  GeneralizedAlpha
  meguid_czekanski()
  {
    return optimal(0., std::sqrt(2.) - 1.);
  }



  GeneralizedAlpha
  generalized_alpha(const double alpha_B,
                    const double alpha_H,
                    const double beta,
                    const double gamma)
  {
    require(alpha_H <= 0.5 + rounding,
            "alpha_H",
            "alpha_H <= 1/2",
            number("alpha_H", alpha_H),
            "the scheme is unstable for high frequencies");
    require(alpha_B <= alpha_H + rounding,
            "alpha_B",
            "alpha_B <= alpha_H",
            number("alpha_B", alpha_B) + ", " + number("alpha_H", alpha_H),
            "the scheme is unstable");
    require(gamma >= 0.5 - alpha_B + alpha_H - rounding,
            "gamma",
            "gamma >= 1/2 - alpha_B + alpha_H",
            number("gamma", gamma),
            "the scheme makes energy");
    require(2. * beta >= gamma - rounding,
            "beta",
            "2 beta >= gamma",
            number("beta", beta) + ", " + number("gamma", gamma),
            "the step size is bounded by the finest element");
    return {alpha_B, alpha_H, beta, gamma};
  }
} // namespace Signorini
