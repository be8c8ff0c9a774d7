#include <signorini/time/step_plan.h>

#include <boost/test/unit_test.hpp>

BOOST_AUTO_TEST_SUITE(step_plan)

using namespace Signorini;

namespace
{
  StepControl
  control(const bool                 automatic,
          const double               size,
          const std::vector<double> &times = {})
  {
    StepControl result;
    result.automatic     = automatic;
    result.initial_size  = size;
    result.times_to_meet = times;
    return result;
  }
} // namespace



BOOST_AUTO_TEST_CASE(fixed_steps_meet_the_grid)
{
  const StepPlan plan(control(false, 0.3), 1.);
  BOOST_TEST(plan.n_regular_steps() == 4u);
  BOOST_TEST(plan.target(0., 0) == 0.3);
  BOOST_TEST(plan.target(0.3, 1) == 2 * 0.3);
  BOOST_TEST(plan.target(0.7, 2) == 3 * 0.3);
  BOOST_TEST(plan.target(0.9, 3) == 1.);
  BOOST_TEST(!plan.completes_regular_step(0.5, 1));
  BOOST_TEST(plan.completes_regular_step(0.1 + 0.5, 1));
  BOOST_TEST(!plan.is_end(0.9));
  BOOST_TEST(plan.is_end(1. - 1e-12));

  // A tiny last step joins the one before.
  const StepPlan longer(control(false, 0.1), 1.00001);
  BOOST_TEST(longer.n_regular_steps() == 10u);
  BOOST_TEST(longer.target(0.9, 9) == 1.00001);
}



// Times to meet lie between; the times of the output do not count.
BOOST_AUTO_TEST_CASE(fixed_steps_meet_load_corners)
{
  const StepPlan plan(control(false, 0.3, {0.5}), 1., {0.35}, 0.2);
  BOOST_TEST(plan.target(0.3, 1) == 0.5);
  BOOST_TEST(!plan.completes_regular_step(0.5, 1));
  BOOST_TEST(plan.target(0.5, 1) == 0.6);
}



BOOST_AUTO_TEST_CASE(automatic_steps_meet_all_times)
{
  const StepPlan plan(control(true, 0.3, {0.1, 0.5, 7.}), 1., {0.35}, 0.2);
  BOOST_TEST(plan.n_regular_steps() == 0u);
  std::vector<double> met;
  double              time = 0.;
  while (!plan.is_end(time))
    {
      time = plan.target(time, met.size());
      met.push_back(time);
    }
  const std::vector<double> truth = {
    0.1, 0.2, 0.35, 0.4, 0.5, 3 * 0.2, 0.8, 1.};
  BOOST_TEST(met == truth, boost::test_tools::per_element());
  BOOST_TEST(plan.completes_regular_step(0.123, 5));

  // A time that was met but for rounding is not met twice.
  BOOST_TEST(plan.target(0.35 - 1e-14, 0) == 0.4);
  BOOST_TEST(plan.target(0.4 - 1e-14, 0) == 0.5);
}



// A run that ended in the middle of the grid goes on to its next time.
BOOST_AUTO_TEST_CASE(later_end)
{
  const StepPlan plan(control(false, 0.3), 2.);
  BOOST_TEST(plan.n_regular_at(1., 4) == 3u);
  BOOST_TEST(plan.target(1., 3) == 4 * 0.3);
  BOOST_TEST(plan.n_regular_at(0.9, 3) == 3u);
  BOOST_TEST(plan.n_regular_at(1.1, 3) == 3u);
  BOOST_TEST(StepPlan(control(true, 0.3), 2.).n_regular_at(1., 9) == 9u);
}

BOOST_AUTO_TEST_SUITE_END()
