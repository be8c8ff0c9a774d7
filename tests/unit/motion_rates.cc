#include <signorini/time/motion_rates.h>

#include <boost/test/unit_test.hpp>

#include <cmath>

BOOST_AUTO_TEST_SUITE(motion_rates)

using namespace Signorini;

BOOST_AUTO_TEST_CASE(of_a_smooth_motion)
{
  // The error is of second order in the difference, at the start as well.
  for (const double time : {0., 0.015, 0.7})
    {
      const auto rates = [&](const double difference) {
        return Signorini::motion_rates(
          [](const double t) { return std::sin(t); }, time, difference);
      };
      BOOST_TEST(std::abs(rates(0.01).velocity - std::cos(time)) < 4e-5);
      BOOST_TEST(std::abs(rates(0.01).acceleration + std::sin(time)) < 1e-4);
      BOOST_TEST(std::abs(rates(0.005).velocity - std::cos(time)) < 1e-5);
    }
}

BOOST_AUTO_TEST_CASE(asked_for_the_time_of_the_run_only)
{
  const auto motion = [](const double t) {
    BOOST_TEST((t >= 0. && t <= 1.));
    return 3. * t * t;
  };
  for (const double time : {0., 0.1, 1.})
    {
      const MotionRates rates = Signorini::motion_rates(motion, time, 0.01);
      BOOST_TEST(std::abs(rates.velocity - 6. * time) < 1e-10);
      BOOST_TEST(std::abs(rates.acceleration - 6.) < 1e-9);
    }
}

BOOST_AUTO_TEST_CASE(a_kink_is_not_yet_felt)
{
  const MotionRates rates =
    Signorini::motion_rates([](const double t) { return std::min(t, 0.5); },
                            0.5,
                            0.01);
  BOOST_TEST(std::abs(rates.velocity - 1.) < 1e-12);
  BOOST_TEST(std::abs(rates.acceleration) < 1e-9);
}

BOOST_AUTO_TEST_SUITE_END()
