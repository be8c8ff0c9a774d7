#include <signorini/output/progress.h>

#include <boost/test/unit_test.hpp>

BOOST_AUTO_TEST_SUITE(progress)

using namespace Signorini;

BOOST_AUTO_TEST_CASE(durations)
{
  BOOST_TEST(format_duration(0.) == "0:00");
  BOOST_TEST(format_duration(12.4) == "0:12");
  BOOST_TEST(format_duration(59.6) == "1:00");
  BOOST_TEST(format_duration(3599.) == "59:59");
  BOOST_TEST(format_duration(3600. + 120. + 3.) == "1:02:03");
  BOOST_TEST(format_duration(100. * 3600.) == "100:00:00");
}

BOOST_AUTO_TEST_CASE(fixed_steps)
{
  Progress state;
  state.step         = 1200;
  state.n_steps      = 2400;
  state.time         = 6e-3;
  state.end_time     = 12e-3;
  state.n_iterations = 1;
  state.n_contacts   = 2;
  state.elapsed      = 12.;
  BOOST_TEST(progress_line(state) ==
             "step 1200/2400  t 6.000e-03 s  iterations 1  contacts 2  "
             "left 0:12");
}

BOOST_AUTO_TEST_CASE(adaptive_steps_after_a_restart)
{
  // A quarter of what this run has to do took 30 s: 90 s are left.
  Progress state;
  state.step       = 7;
  state.start_time = 2.;
  state.time       = 3.;
  state.end_time   = 6.;
  state.elapsed    = 30.;
  BOOST_TEST(progress_line(state) ==
             "step 7  t 3.000e+00 s  iterations 0  contacts 0  left 1:30");
}

BOOST_AUTO_TEST_CASE(before_the_first_step_nothing_is_known)
{
  Progress state;
  state.end_time = 1.;
  BOOST_TEST(progress_line(state).find("left") == std::string::npos);
}

BOOST_AUTO_TEST_SUITE_END()
