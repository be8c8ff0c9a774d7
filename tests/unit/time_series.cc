#include <signorini/output/time_series.h>

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <limits>

BOOST_AUTO_TEST_SUITE(time_series, *boost::unit_test::tolerance(1e-14))

using namespace Signorini;

namespace
{
  // 0 at 0, 2 at 1, 2 at 2, -4 at 4: steps of different length.
  const TimeSeries series{{0., 1., 2., 4.}, {0., 2., 2., -4.}};

  const Condition positive{Condition::Comparison::greater, 0.};

  const double not_a_number = std::numeric_limits<double>::quiet_NaN();
} // namespace



BOOST_AUTO_TEST_CASE(extremes)
{
  BOOST_TEST(maximum(series) == 2.);
  BOOST_TEST(minimum(series) == -4.);
  BOOST_TEST(maximum_absolute(series) == 4.);
  BOOST_TEST(final_value(series) == -4.);
}

BOOST_AUTO_TEST_CASE(a_nan_is_not_hidden)
{
  for (const TimeSeries &broken : {TimeSeries{{0., 1.}, {not_a_number, 1.}},
                                   TimeSeries{{0., 1.}, {1., not_a_number}}})
    {
      BOOST_TEST(std::isnan(maximum(broken)));
      BOOST_TEST(std::isnan(minimum(broken)));
      BOOST_TEST(std::isnan(maximum_absolute(broken)));
      BOOST_TEST(std::isnan(mean(broken)));
    }
}

BOOST_AUTO_TEST_CASE(values_between_rows)
{
  BOOST_TEST(interpolate(series, 0.) == 0.);
  BOOST_TEST(interpolate(series, 0.25) == 0.5);
  BOOST_TEST(interpolate(series, 1.) == 2.);
  BOOST_TEST(interpolate(series, 3.) == -1.);
  BOOST_TEST(interpolate(series, 4.) == -4.);
  BOOST_TEST(interpolate(series, 4. * (1. + 1e-12)) == -4.);
  BOOST_CHECK_THROW(interpolate(series, 4.1), NoValue);
  BOOST_CHECK_THROW(interpolate(series, -0.1), NoValue);
  BOOST_CHECK_THROW(interpolate(series, not_a_number), NoValue);
  // At a jump the later row counts.
  BOOST_TEST(interpolate({{0., 1., 1., 2.}, {0., 1., 5., 6.}}, 1.) == 5.);
}

// Integral of the whole: 1 + 2 + (2 - 4) / 2 * 2 = 1 over 4 s. From 0.5 to 3:
// 0.75 + 2 + (2 - 1) / 2 = 3.25 over 2.5 s.
BOOST_AUTO_TEST_CASE(mean_over_time)
{
  BOOST_TEST(mean(series) == 0.25);
  BOOST_TEST(mean(part_between(series, 0.5, 3.)) == 1.3);
  // A window within one step, of length zero, and a single row.
  BOOST_TEST(mean(part_between(series, 0.25, 0.75)) == 1.);
  BOOST_TEST(mean(part_between(series, 0.5, 0.5)) == 1.);
  BOOST_TEST(mean(TimeSeries{{3.}, {7.}}) == 7.);
}

BOOST_AUTO_TEST_CASE(windows)
{
  BOOST_TEST(rows_between(series, 0.5, 2.).times ==
             (std::vector<double>{1., 2.}));
  // A sum of ten steps of 0.1 is not quite 1.
  double sum = 0.;
  for (unsigned int i = 0; i < 10; ++i)
    sum += 0.1;
  BOOST_TEST((sum < 1.));
  BOOST_TEST(rows_between({{0., sum}, {1., 2.}}, 1., 1.).values ==
             std::vector<double>{2.});
  BOOST_CHECK_THROW(rows_between(series, 2.5, 3.5), NoValue);
  BOOST_CHECK_THROW(rows_between(series, 1., 5.), NoValue);
  BOOST_CHECK_THROW(part_between(series, -1., 2.), NoValue);
}

BOOST_AUTO_TEST_CASE(times_of_conditions)
{
  BOOST_TEST(first_time(series, positive) == 1.);
  BOOST_TEST(last_time(series, positive) == 2.);
  BOOST_CHECK_THROW(first_time(series, {Condition::Comparison::greater, 9.}),
                    NoValue);
  BOOST_CHECK_THROW(last_time(series, {Condition::Comparison::greater, 9.}),
                    NoValue);
  BOOST_TEST(switch_times(series, positive) == (std::vector<double>{1., 4.}));
  // True from the first row on: that is a switch, too.
  BOOST_TEST(switch_times(series, {Condition::Comparison::less, 1.}) ==
             (std::vector<double>{0., 1., 4.}));
}

BOOST_AUTO_TEST_CASE(comparisons)
{
  using Comparison = Condition::Comparison;
  const auto holds = [](const Comparison comparison, const double value) {
    return Condition{comparison, 1.}.holds(value);
  };
  BOOST_TEST((holds(Comparison::less, 0.) && !holds(Comparison::less, 1.)));
  BOOST_TEST((holds(Comparison::less_or_equal, 1.) &&
              !holds(Comparison::less_or_equal, 2.)));
  BOOST_TEST(
    (holds(Comparison::greater, 2.) && !holds(Comparison::greater, 1.)));
  BOOST_TEST((holds(Comparison::greater_or_equal, 1.) &&
              !holds(Comparison::greater_or_equal, 0.)));
}

BOOST_AUTO_TEST_CASE(no_rows_no_value)
{
  BOOST_CHECK_THROW(maximum({}), NoValue);
  BOOST_CHECK_THROW(minimum({}), NoValue);
  BOOST_CHECK_THROW(maximum_absolute({}), NoValue);
  BOOST_CHECK_THROW(final_value({}), NoValue);
  BOOST_CHECK_THROW(mean({}), NoValue);
  BOOST_CHECK_THROW(interpolate({}, 0.), NoValue);
  BOOST_CHECK_THROW(rows_between({}, 0., 0.), NoValue);
  BOOST_CHECK_THROW(switch_times({}, positive), NoValue);
}

BOOST_AUTO_TEST_SUITE_END()
