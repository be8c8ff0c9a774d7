#include <signorini/time/step_error.h>

#include <boost/test/unit_test.hpp>

#include <cmath>

BOOST_AUTO_TEST_SUITE(step_error)

using namespace Signorini;

namespace
{
  // A motion with constant third derivative, from rest.
  constexpr double jerk = 6.;

  double
  displacement(const double t)
  {
    return jerk * t * t * t / 6.;
  }

  double
  velocity(const double t)
  {
    return jerk * t * t / 2.;
  }

  // Newmark's formula with accelerations that lag behind.
  double
  error_of_newmark(const GeneralizedAlpha &scheme,
                   const double            t,
                   const double            dt)
  {
    const double lag = (scheme.alpha_H - scheme.alpha_B) * dt;
    const double a_n = jerk * (t - lag), a_np = jerk * (t + dt - lag);
    return displacement(t) + dt * velocity(t) +
           dt * dt * ((0.5 - scheme.beta) * a_n + scheme.beta * a_np) -
           displacement(t + dt);
  }
} // namespace



// Over a constant jerk the estimate is the error itself.
BOOST_AUTO_TEST_CASE(constant_jerk)
{
  for (const GeneralizedAlpha &scheme : {trapezoidal_rule(),
                                         newmark(0.3, 0.55),
                                         chung_hulbert(0.5),
                                         chung_hulbert(0.98),
                                         meguid_czekanski()})
    {
      const double t = 0.7, dt = 0.01, speed = 2.;
      const double truth = std::abs(error_of_newmark(scheme, t, dt));
      BOOST_TEST(relative_step_error(scheme, dt, jerk * dt, speed) ==
                   truth / (speed * dt),
                 boost::test_tools::tolerance(1e-8));
    }
}



// An oscillation by the trapezoidal rule: the largest estimate is the relative
// error of the period, (omega dt)^2/12.
BOOST_AUTO_TEST_CASE(period_of_an_oscillation)
{
  const GeneralizedAlpha scheme = trapezoidal_rule();
  const double           omega = 3., dt = 0.02;
  double                 u = 1., v = 0., a = -omega * omega;
  double                 largest = 0., n_steps = 0.;
  while (true)
    {
      // u_np + beta dt^2 omega^2 u_np = predictor
      const double predictor = u + dt * v + 0.25 * dt * dt * a;
      const double u_np = predictor / (1. + 0.25 * omega * omega * dt * dt);
      const double a_np = -omega * omega * u_np;
      const double v_np = v + 0.5 * dt * (a + a_np);
      largest           = std::max(
        largest,
        relative_step_error(scheme, dt, std::abs(a_np - a), /*speed=*/omega));
      const bool half_turn = v < 0. && v_np >= 0.;
      if (half_turn)
        {
          // Where the velocity crosses zero, half a period has passed.
          n_steps += v / (v - v_np);
          break;
        }
      n_steps += 1.;
      u = u_np, v = v_np, a = a_np;
    }
  const double pi           = std::acos(-1.);
  const double period_error = 2. * n_steps * dt / (2. * pi / omega) - 1.;
  BOOST_TEST(period_error == omega * omega * dt * dt / 12.,
             boost::test_tools::tolerance(0.01));
  BOOST_TEST(largest == period_error, boost::test_tools::tolerance(0.01));
}



BOOST_AUTO_TEST_CASE(nothing_moves)
{
  BOOST_TEST(relative_step_error(trapezoidal_rule(), 0.1, 5., 0.) == 0.);
}

BOOST_AUTO_TEST_SUITE_END()
