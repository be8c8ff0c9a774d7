#include <signorini/input/input_error.h>
#include <signorini/time/generalized_alpha.h>

#include <deal.II/lac/vector.h>

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <map>

BOOST_AUTO_TEST_SUITE(generalized_alpha)

using namespace Signorini;
using dealii::Vector;

namespace
{
  // The oscillator u'' + 2 d w u' + w^2 u = w^2 sin(t), u(0) = 1, v(0) = 0.
  constexpr double omega = 3., damping = 0.05, end_time = 2.;

  struct Motion
  {
    double displacement, velocity;
  };

  // Exact: particular solution p sin t + q cos t, and the damped free one.
  Motion
  exact(const double t)
  {
    const double w2 = omega * omega, c = 2. * damping * omega;
    const double det = (w2 - 1.) * (w2 - 1.) + c * c;
    const double p = w2 * (w2 - 1.) / det, q = -w2 * c / det;
    const double decay = damping * omega,
                 wd    = omega * std::sqrt(1. - damping * damping);
    const double a = 1. - q, b = (-p + decay * a) / wd;
    const double e = std::exp(-decay * t);
    return {p * std::sin(t) + q * std::cos(t) +
              e * (a * std::cos(wd * t) + b * std::sin(wd * t)),
            p * std::cos(t) - q * std::sin(t) +
              e * ((b * wd - decay * a) * std::cos(wd * t) -
                   (a * wd + decay * b) * std::sin(wd * t))};
  }

  Motion
  integrate(const GeneralizedAlpha &scheme, const unsigned int n_steps)
  {
    const double   dt = end_time / n_steps, w2 = omega * omega;
    const double   c    = 2. * damping * omega;
    const auto     load = [&](const double t) { return w2 * std::sin(t); };
    Vector<double> u(1), v(1), a(1);
    u[0] = 1.;
    a[0] = load(0.) - w2 * u[0];
    for (unsigned int n = 0; n < n_steps; ++n)
      {
        const double aH = scheme.alpha_H, aB = scheme.alpha_B;
        // residual at u_np = u_n, then one exact correction
        Vector<double> a_np = scheme.acceleration(u, u, v, a, dt);
        Vector<double> v_np = scheme.velocity(a_np, v, a, dt);
        const double   f = (1. - aH) * load((n + 1) * dt) + aH * load(n * dt);
        const double   r = f - ((1. - aB) * a_np[0] + aB * a[0]) -
                         c * ((1. - aH) * v_np[0] + aH * v[0]) - w2 * u[0];
        const double k = (1. - aB) * scheme.acceleration_factor(dt) +
                         (1. - aH) * (c * scheme.velocity_factor(dt) + w2);
        Vector<double> u_np(u);
        u_np[0] += r / k;
        a_np = scheme.acceleration(u_np, u, v, a, dt);
        v_np = scheme.velocity(a_np, v, a, dt);
        u    = u_np;
        v    = v_np;
        a    = a_np;
      }
    return {u[0], v[0]};
  }
} // namespace



// Halving the step divides the errors of U and V by four.
BOOST_AUTO_TEST_CASE(second_order)
{
  const std::map<std::string, GeneralizedAlpha> schemes = {
    {"trapezoidal", trapezoidal_rule()},
    {"Chung-Hulbert 0.95", chung_hulbert(0.95)},
    {"Chung-Hulbert 0", chung_hulbert(0.)},
    {"HHT 0.1", hilber_hughes_taylor(0.1)},
    {"Meguid-Czekanski", meguid_czekanski()},
    {"WBZ, alpha_B = -0.2", Signorini::generalized_alpha(-0.2, 0., 0.36, 0.7)}};
  for (const auto &[name, scheme] : schemes)
    {
      BOOST_TEST_INFO(name);
      BOOST_TEST(scheme.is_second_order());
      const Motion truth  = exact(end_time);
      const Motion coarse = integrate(scheme, 800),
                   fine   = integrate(scheme, 1600);
      const double order_u =
        std::log2(std::abs((coarse.displacement - truth.displacement) /
                           (fine.displacement - truth.displacement)));
      const double order_v = std::log2(std::abs(
        (coarse.velocity - truth.velocity) / (fine.velocity - truth.velocity)));
      BOOST_TEST_MESSAGE(name << ": order " << order_u << " in U, " << order_v
                              << " in V");
      BOOST_TEST(std::abs(order_u - 2.) < 0.05, name << " U " << order_u);
      BOOST_TEST(std::abs(order_v - 2.) < 0.05, name << " V " << order_v);
    }
  const GeneralizedAlpha first_order = newmark(0.4, 0.7);
  BOOST_TEST(!first_order.is_second_order());
}



// The amplification of infinitely stiff modes is the radius asked for.
BOOST_AUTO_TEST_CASE(spectral_radius)
{
  for (const double rho : {0., 0.5, 0.8, 1.})
    {
      const GeneralizedAlpha s = chung_hulbert(rho);
      // For w dt -> infinity all three eigenvalues of the step tend to -rho
      // (double) and -alpha_H/(1 - alpha_H), which is -rho as well.
      BOOST_TEST(std::abs(s.alpha_H / (1. - s.alpha_H) - rho) < 1e-14);
      BOOST_TEST(s.alpha_B <= s.alpha_H + 1e-15);
      BOOST_TEST(s.alpha_H <= 0.5 + 1e-15);
    }
  const GeneralizedAlpha paper = meguid_czekanski();
  BOOST_TEST(std::abs(paper.beta - 0.5) < 1e-15);
  BOOST_TEST(std::abs(paper.gamma - (std::sqrt(2.) - 0.5)) < 1e-15);
}



BOOST_AUTO_TEST_CASE(unstable_numbers_are_refused)
{
  BOOST_CHECK_THROW(chung_hulbert(1.1), InputError);
  BOOST_CHECK_THROW(chung_hulbert(-0.1), InputError);
  BOOST_CHECK_THROW(hilber_hughes_taylor(-0.1), InputError);
  BOOST_CHECK_THROW(hilber_hughes_taylor(0.6), InputError);
  BOOST_CHECK_THROW(newmark(0.2, 0.5), InputError);
  BOOST_CHECK_THROW(newmark(0.25, 0.4), InputError);
  BOOST_CHECK_THROW(Signorini::generalized_alpha(0.3, 0.2, 0.3, 0.5),
                    InputError);
  BOOST_CHECK_THROW(Signorini::generalized_alpha(0., 0.7, 1., 1.2), InputError);
}

BOOST_AUTO_TEST_SUITE_END()
