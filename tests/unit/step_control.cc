#include <signorini/input/input_error.h>
#include <signorini/time/step_control.h>

#include <deal.II/base/parameter_handler.h>

#include <boost/test/unit_test.hpp>

BOOST_AUTO_TEST_SUITE(step_control)

using namespace Signorini;

namespace
{
  StepControl
  automatic()
  {
    StepControl control;
    control.automatic       = true;
    control.initial_size    = 0.1;
    control.minimal_size    = 1e-3;
    control.maximal_size    = 10.;
    control.easy_iterations = 5;
    return control;
  }

  StepTrial
  trial(const double       size,
        const unsigned int n_iterations,
        const double       error          = 0.,
        const double       rejected_error = 0.)
  {
    StepTrial result;
    result.size           = size;
    result.n_iterations   = n_iterations;
    result.error          = error;
    result.rejected_error = rejected_error;
    return result;
  }

  StepTrial
  failure(const double size)
  {
    StepTrial result = trial(size, 25);
    result.converged = false;
    return result;
  }

  // The memory after accepted steps of the wanted size.
  StepMemory
  after(const StepControl &control,
        StepMemory         memory,
        const unsigned int n_steps,
        const unsigned int n_iterations,
        const double       error = 0.)
  {
    for (unsigned int i = 0; i < n_steps; ++i)
      {
        const StepVerdict verdict =
          judge_step(control,
                     memory,
                     trial(memory.wanted_size, n_iterations, error));
        BOOST_TEST(verdict.is_accepted);
        memory = verdict.memory;
      }
    return memory;
  }

  StepControl
  parsed(const std::string &text, const bool dynamic)
  {
    dealii::ParameterHandler prm;
    prm.declare_entry("Step size", "0.1", dealii::Patterns::Double());
    StepControl::declare_parameters(prm);
    prm.parse_input_from_string(text);
    return StepControl::parse(/*end_time=*/2., dynamic, prm);
  }
} // namespace



// As it was before there were automatic steps: the regular size; halves after
// a failure; then doubled until the size is regular again.
BOOST_AUTO_TEST_CASE(fixed_steps)
{
  StepControl control;
  control.initial_size = 0.1;
  control.minimal_size = 1e-3;
  StepMemory memory(0.1);
  BOOST_TEST(next_step_size(control, memory, 0.3, 0.4) == 0.1);
  BOOST_TEST(next_step_size(control, memory, 0.3, 0.35) == 0.35 - 0.3);
  BOOST_TEST(next_step_size(control, memory, 0., 0.1001) == 0.1001);

  StepVerdict verdict = judge_step(control, memory, failure(0.1));
  BOOST_TEST(!verdict.is_accepted);
  BOOST_TEST(verdict.next_size == 0.05);
  BOOST_TEST(verdict.reason == "cut in half");
  verdict = judge_step(control, verdict.memory, failure(0.05));
  BOOST_TEST(verdict.next_size == 0.025);
  verdict = judge_step(control, verdict.memory, trial(0.025, 20, 7.));
  BOOST_TEST(verdict.is_accepted);
  BOOST_TEST(verdict.reason == "");
  BOOST_TEST(next_step_size(control, verdict.memory, 0.025, 0.1) == 0.05);
}



// From 0 to 1 with steps of at most 0.3: four of 0.25, whose size is the same
// to the bit, so that one factor serves for all.
BOOST_AUTO_TEST_CASE(automatic_steps_share_the_way)
{
  const StepControl control = automatic();
  StepMemory        memory(0.3);
  double            time = 0.;
  for (unsigned int i = 0; i < 4; ++i)
    {
      memory.last_size = next_step_size(control, memory, time, 1.);
      BOOST_TEST(memory.last_size == 0.25);
      time += memory.last_size;
    }
  BOOST_TEST(time == 1.);

  // Thirds are not exact: the size stays the same nevertheless.
  memory.last_size   = next_step_size(control, memory, 0.1, 1.);
  const double third = memory.last_size;
  for (time = 0.1 + third; time < 0.95; time += third)
    BOOST_TEST(next_step_size(control, memory, time, 1.) == third);

  // One step is enough where the wanted size reaches.
  BOOST_TEST(next_step_size(control, memory, 1., 1.2) == 1.2 - 1.);

  // The limit is that of the control, though the size was chosen with another.
  StepControl shorter  = control;
  shorter.maximal_size = 0.125;
  BOOST_TEST(next_step_size(shorter, StepMemory(0.3), 0., 1.) == 0.125);
}



BOOST_AUTO_TEST_CASE(easy_steps_grow)
{
  const StepControl control = automatic();
  StepMemory        memory  = after(control, StepMemory(0.1), 1, 5);
  BOOST_TEST(memory.wanted_size == 0.1);
  const StepVerdict verdict = judge_step(control, memory, trial(0.1, 1));
  BOOST_TEST(verdict.is_accepted);
  BOOST_TEST(verdict.memory.wanted_size == 0.2);
  BOOST_TEST(verdict.reason == "steps grow to 0.2 s: converged in 1 iteration");

  // A step of more iterations in between begins the count again.
  memory = after(control, StepMemory(0.1), 1, 5);
  memory = after(control, memory, 1, 6);
  memory = after(control, memory, 1, 5);
  BOOST_TEST(memory.wanted_size == 0.1);
  BOOST_TEST(after(control, memory, 1, 5).wanted_size == 0.2);

  // A step that was cut short to meet a time is no evidence.
  memory = after(control, StepMemory(0.1), 1, 5);
  memory = judge_step(control, memory, trial(0.04, 1)).memory;
  BOOST_TEST(memory.wanted_size == 0.1);
  BOOST_TEST(memory.n_easy_steps == 1u);
}



BOOST_AUTO_TEST_CASE(never_above_the_maximal_size)
{
  StepControl control  = automatic();
  control.maximal_size = 0.25;
  // 1.25 times is no growth by 1.5, but the last one.
  const StepMemory memory = after(control, StepMemory(0.1), 20, 1);
  BOOST_TEST(memory.wanted_size == 0.25);
}



// A size that fails is halved at once, and tried again later and later.
BOOST_AUTO_TEST_CASE(failures_make_patient)
{
  const StepControl control = automatic();
  StepVerdict verdict = judge_step(control, StepMemory(0.1), failure(0.1));
  BOOST_TEST(!verdict.is_accepted);
  BOOST_TEST(verdict.next_size == 0.05);
  BOOST_TEST(verdict.memory.wanted_size == 0.05);
  StepMemory memory = after(control, verdict.memory, 7, 1);
  BOOST_TEST(memory.wanted_size == 0.05);
  memory = after(control, memory, 1, 1);
  BOOST_TEST(memory.wanted_size == 0.1);

  memory = judge_step(control, memory, failure(0.1)).memory;
  memory = after(control, memory, 15, 1);
  BOOST_TEST(memory.wanted_size == 0.05);
  memory = after(control, memory, 1, 1);
  BOOST_TEST(memory.wanted_size == 0.1);

  // Peace comes back when the grown size lasts.
  memory = after(control, memory, 8 + 4, 1);
  BOOST_TEST(memory.patience == 2u);
}



// e falls with the square of the size.
BOOST_AUTO_TEST_CASE(errors_above_the_tolerance_repeat_the_step)
{
  const StepControl control = automatic();
  const StepVerdict verdict =
    judge_step(control, StepMemory(0.1), trial(0.1, 1, 4.));
  BOOST_TEST(!verdict.is_accepted);
  BOOST_TEST(verdict.next_size == 0.04, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(verdict.reason == "error 4 of the tolerance; cut to 0.04 s");

  // Not below a tenth, and not below the minimal size.
  BOOST_TEST(
    judge_step(control, StepMemory(0.1), trial(0.1, 1, 1e9)).next_size == 0.01,
    boost::test_tools::tolerance(1e-12));
  BOOST_TEST(
    judge_step(control, StepMemory(0.1), trial(2e-3, 1, 1e9)).next_size ==
    1e-3);
  BOOST_TEST(
    judge_step(control, StepMemory(0.1), trial(1e-3, 1, 1e9)).is_accepted);
  BOOST_TEST(
    judge_step(control, StepMemory(0.1), trial(0.1, 1, 1.)).is_accepted);
}



// Cut to a third, e would fall to a ninth; a jump stays as it is.
BOOST_AUTO_TEST_CASE(jumps_are_not_cut_for_ever)
{
  const StepControl control = automatic();
  BOOST_TEST(
    !judge_step(control, StepMemory(0.1), trial(0.03, 1, 5., 20.)).is_accepted);
  const StepVerdict verdict =
    judge_step(control, StepMemory(0.1), trial(0.03, 1, 19.5, 20.));
  BOOST_TEST(verdict.is_accepted);
  BOOST_TEST(verdict.memory.n_easy_steps == 0u);
}



BOOST_AUTO_TEST_CASE(errors_bound_the_growth)
{
  const StepControl control = automatic();
  // 0.8 e^(-1/2): 2.53, 1.6, and 1.43, which is not worth a factorisation.
  BOOST_TEST(after(control, StepMemory(0.1), 2, 1, 0.1).wanted_size == 0.2);
  BOOST_TEST(after(control, StepMemory(0.1), 2, 1, 0.25).wanted_size == 0.16,
             boost::test_tools::tolerance(1e-12));
  BOOST_TEST(after(control, StepMemory(0.1), 50, 1, 0.3125).wanted_size == 0.1);

  const StepMemory  memory  = after(control, StepMemory(0.1), 1, 1, 0.25);
  const StepVerdict verdict = judge_step(control, memory, trial(0.1, 2, 0.25));
  BOOST_TEST(verdict.reason == "steps grow to 0.16 s: converged in 2 "
                               "iterations, error 0.25 of the tolerance");

  // A large error is remembered for some steps: 0.9^n 0.9 <= 0.284 from 11 on.
  StepMemory late = after(control, StepMemory(0.1), 1, 1, 0.9);
  late            = after(control, late, 10, 1, 1e-6);
  BOOST_TEST(late.wanted_size == 0.1);
  BOOST_TEST(after(control, late, 1, 1, 1e-6).wanted_size > 0.15);
}



BOOST_AUTO_TEST_CASE(entries)
{
  const StepControl defaults = parsed("", true);
  BOOST_TEST(!defaults.automatic);
  BOOST_TEST(defaults.initial_size == 0.1);
  BOOST_TEST(defaults.minimal_size == 0.1 / 1024.);

  const StepControl control = parsed("set Step control = automatic\n"
                                     "set Times to meet = 0.5, pi/10, 0.1\n"
                                     "set Minimal step size = 0.01\n",
                                     false);
  BOOST_TEST(control.automatic);
  BOOST_TEST(control.minimal_size == 0.01);
  BOOST_TEST(control.maximal_size == 2.);
  const std::vector<double> times = {0.1, dealii::numbers::PI / 10., 0.5};
  BOOST_TEST(control.times_to_meet == times, boost::test_tools::per_element());

  const std::string on = "set Step control = automatic\n";
  BOOST_CHECK_NO_THROW(parsed(on + "set Time error tolerance = 1e-3", true));
  BOOST_CHECK_NO_THROW(parsed(on + "set Maximal step size = 1", true));
  BOOST_CHECK_THROW(parsed(on, true), InputError);
  BOOST_CHECK_THROW(parsed(on + "set Time error tolerance = 1e-3", false),
                    InputError);
  BOOST_CHECK_THROW(parsed(on + "set Maximal step size = 0.05", false),
                    InputError);
  BOOST_CHECK_THROW(parsed("set Times to meet = 0", false), InputError);
  BOOST_CHECK_THROW(parsed("set Minimal step size = 0.2", false), InputError);
}

BOOST_AUTO_TEST_SUITE_END()
