#include <signorini/input/parameter_file.h>
#include <signorini/run/step_driver.h>
#include <signorini/time/step_plan.h>

#include <deal.II/base/parameter_handler.h>

#include <boost/test/unit_test.hpp>

#include <sstream>

BOOST_AUTO_TEST_SUITE(step_driver)

using namespace Signorini;
using namespace dealii;

namespace
{
  Problem<2>
  read(const std::string &path)
  {
    const ParameterFile  file    = ParameterFile::read(path);
    const ProblemOutline outline = ProblemOutline::read(file);
    ParameterHandler     prm;
    declare_problem_parameters<2>(outline, prm);
    file.apply(prm);
    return Problem<2>::create(outline, file.directory(), {}, prm);
  }
} // namespace



// Steps of one size have one factor, whatever rounding makes of the times at
// which they begin: one of the initial accelerations and one of the steps. Up
// to the first contact, at step 119, which may take mass from nodes.
BOOST_AUTO_TEST_CASE(factorises_once_for_steps_of_one_size)
{
  const Problem<2>   problem = read("prm/cantilever_beam.prm");
  const StepControl &control = problem.time.step_control;
  const StepPlan     plan(control, problem.time.end_time);
  Timings            timings;
  StepDriver<2>      driver(problem, timings);
  std::ostringstream console;
  Log                log("", console, Log::Settings());
  RunRecord          record;
  record.step_memory             = StepMemory(control.initial_size);
  record.state                   = driver.initial_state();
  bool differences_are_all_alike = true;
  while (record.n_regular < 100)
    {
      const double begin = record.state.time;
      driver.advance(plan.target(begin, record.n_regular), "", record, log);
      ++record.n_regular;
      if (record.state.time - begin != control.initial_size)
        differences_are_all_alike = false;
    }
  BOOST_TEST(record.state.step == 100);
  BOOST_TEST(!differences_are_all_alike);
  BOOST_TEST(timings.n_calls("factorisation") == 2);
}



// A step begins with the tangent that the one before has ended with.
BOOST_AUTO_TEST_CASE(assembles_once_an_iteration)
{
  const Problem<2> problem = read("tests/verification/snapped_arch_damped.prm");
  const StepControl &control = problem.time.step_control;
  const StepPlan     plan(control, problem.time.end_time);
  Timings            timings;
  StepDriver<2>      driver(problem, timings);
  std::ostringstream console;
  Log                log("", console, Log::Settings());
  RunRecord          record;
  record.step_memory           = StepMemory(control.initial_size);
  record.state                 = driver.initial_state();
  const unsigned int n_initial = timings.n_calls("assembly");
  for (; record.n_regular < 3; ++record.n_regular)
    driver.advance(plan.target(record.state.time, record.n_regular),
                   "",
                   record,
                   log);
  BOOST_TEST(record.counts.n_iterations > 3u);
  BOOST_TEST(timings.n_calls("assembly") ==
             n_initial + record.counts.n_iterations);
}

BOOST_AUTO_TEST_SUITE_END()
