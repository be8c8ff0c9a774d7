#include <signorini/input/as_text.h>
#include <signorini/input/input_error.h>
#include <signorini/input/named_list.h>
#include <signorini/input/number_text.h>
#include <signorini/time/step_control.h>

#include <deal.II/base/parameter_handler.h>

#include <algorithm>
#include <cmath>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    // Sizes and times are sums and quotients; this much is rounding.
    constexpr double rounding_of_size = 1e-9;

    // Of an error that falls with the square of the size.
    constexpr double safety = 0.8;

    std::string
    count(const unsigned int n)
    {
      return std::to_string(n) + (n == 1 ? " iteration" : " iterations");
    }

    // Which error is left over when an earlier cut was of no use.
    bool
    cut_was_useless(const StepTrial &trial)
    {
      return trial.rejected_error > 0. &&
             trial.error > 0.9 * trial.rejected_error;
    }

    StepVerdict
    refuse(const StepMemory  &memory,
           const double       next_size,
           const std::string &reason)
    {
      StepVerdict verdict{false, next_size, memory, reason};
      verdict.memory.wanted_size  = next_size;
      verdict.memory.n_easy_steps = 0;
      return verdict;
    }

    // The wanted size after an accepted step: the old one, or a greater one.
    double
    grown_size(const StepControl &control, const StepMemory &memory)
    {
      double size = std::min(2. * memory.wanted_size, control.maximal_size);
      if (memory.error_rate > 0.)
        size = std::min(size, safety / std::sqrt(memory.error_rate));
      const bool reaches_maximum =
        size == control.maximal_size &&
        size > (1. + rounding_of_size) * memory.wanted_size;
      return size >= 1.5 * memory.wanted_size || reaches_maximum ?
               size :
               memory.wanted_size;
    }

    StepVerdict
    accept(const StepControl &control,
           const StepMemory  &memory,
           const StepTrial   &trial)
    {
      StepVerdict verdict{true, 0., memory, ""};
      StepMemory &next = verdict.memory;
      next.last_size   = trial.size;
      next.error_rate  = std::max(0.9 * memory.error_rate,
                                 trial.error / (trial.size * trial.size));
      if (trial.n_iterations > control.easy_iterations || trial.error > 1.)
        next.n_easy_steps = 0;
      else if (trial.size >= 0.5 * (1. - rounding_of_size) * memory.wanted_size)
        // A step that was much shorter, to meet a time, says nothing.
        ++next.n_easy_steps;
      if (next.n_easy_steps < next.patience)
        return verdict;

      const double size = grown_size(control, next);
      if (size == next.wanted_size)
        return verdict;
      verdict.reason = "steps grow to " + as_text(size) + " s: converged in " +
                       count(trial.n_iterations);
      if (trial.error > 0.)
        verdict.reason +=
          ", error " + as_text(trial.error) + " of the tolerance";
      next.wanted_size  = size;
      next.n_easy_steps = 0;
      next.patience     = std::max(2u, next.patience / 2);
      return verdict;
    }
  } // namespace



  void
  StepControl::declare_parameters(ParameterHandler &prm)
  {
    prm.declare_entry("Step control",
                      "fixed",
                      Patterns::Selection("fixed|automatic"),
                      "fixed: all steps have the Step size, but for cuts. "
                      "automatic: the Step size is that of the first step; "
                      "steps grow where they converge easily, and in dynamics "
                      "as far as the Time error tolerance allows. They end at "
                      "the times of the output exactly.");
    prm.declare_entry("Minimal step size",
                      "0",
                      Patterns::Double(0.),
                      "A step that does not converge is cut in half, down to "
                      "this size; 0 means 1/1024 of the step size. Unit: s.");
    prm.declare_entry("Maximal step size",
                      "0",
                      Patterns::Double(0.),
                      "Automatic steps do not grow beyond it; 0: no limit, "
                      "which a dynamic run allows only with a Time error "
                      "tolerance. Unit: s.");
    prm.declare_entry("Iterations of an easy step",
                      "5",
                      Patterns::Integer(1, 10000),
                      "Automatic steps that take at most so many iterations "
                      "let the next ones grow.");
    prm.declare_entry(
      "Time error tolerance",
      "0",
      Patterns::Double(0., 1.),
      "Largest error of an automatic step in dynamics, relative "
      "to the way that the largest speed so far makes in the "
      "step; 0: not estimated. With the trapezoidal rule it is "
      "the relative error of the period of an oscillation: "
      "1e-3 gives 57 steps a period. Unit: 1.");
    prm.declare_entry("Times to meet",
                      "",
                      NumberText(),
                      "Times, separated by commas, at which a step has to end, "
                      "because a load or a motion has a jump or a kink there. "
                      "Unit: s.");
  }



  EntryConditions
  StepControl::conditions()
  {
    return {contradiction(read_with({"Maximal step size",
                                     "Iterations of an easy step",
                                     "Time error tolerance"},
                                    "Step control",
                                    {"automatic"}))};
  }



  StepControl
  StepControl::parse(const double            end_time,
                     const bool              dynamic,
                     const ParameterHandler &prm)
  {
    StepControl control;
    control.automatic       = prm.get("Step control") == "automatic";
    control.initial_size    = prm.get_double("Step size");
    control.minimal_size    = prm.get_double("Minimal step size");
    control.maximal_size    = prm.get_double("Maximal step size");
    control.error_tolerance = prm.get_double("Time error tolerance");
    control.easy_iterations = prm.get_integer("Iterations of an easy step");
    const std::string entry = "Time / Times to meet";
    for (const auto &text : split_list(prm.get("Times to meet"), ','))
      {
        const double time = parse_number(text, entry);
        if (time <= 0.)
          throw InputError(entry,
                           "found " + text +
                             ". Times must be greater than zero, in s; a run "
                             "begins at t = 0 anyway.");
        control.times_to_meet.push_back(time);
      }
    std::sort(control.times_to_meet.begin(), control.times_to_meet.end());
    // Beyond it a time and the next one are the same number.
    if (control.minimal_size > 0. && control.minimal_size < 1e-12 * end_time)
      throw InputError("Time / Minimal step size",
                       "found " + as_text(control.minimal_size) +
                         " s, which is less than 1e-12 of the End time of " +
                         as_text(end_time) +
                         " s: times so close cannot be told apart. Choose a "
                         "greater one, or 0 for 1/1024 of the Step size.");
    if (control.minimal_size > control.initial_size)
      throw InputError("Time / Minimal step size",
                       "found " + as_text(control.minimal_size) +
                         " s, which is greater than the Step size of " +
                         as_text(control.initial_size) +
                         " s. Choose a smaller one, or 0 for the default.");
    if (control.minimal_size == 0.)
      control.minimal_size = control.initial_size / 1024.;
    if (!control.automatic)
      return control;

    if (control.error_tolerance > 0. && !dynamic)
      throw InputError(
        "Time / Time error tolerance",
        "a static run has no error in time. Leave the entry out; Maximal step "
        "size bounds the steps.");
    if (dynamic && control.error_tolerance == 0. && control.maximal_size == 0.)
      throw InputError(
        "Time / Step control",
        "automatic steps of a dynamic run need a Time error tolerance, such as "
        "1e-3, or a Maximal step size: elsewise nothing would bound them.");
    if (control.maximal_size == 0.)
      control.maximal_size = end_time;
    if (control.maximal_size < control.initial_size)
      throw InputError("Time / Maximal step size",
                       "found " + as_text(control.maximal_size) +
                         " s, which is less than the Step size of " +
                         as_text(control.initial_size) +
                         " s. Choose a greater one, or 0 for no limit.");
    return control;
  }



  double
  next_step_size(const StepControl &control,
                 const StepMemory  &memory,
                 const double       time,
                 const double       target)
  {
    // A resumed run may have another limit than the one that chose the size.
    const double left   = target - time;
    const double wanted = std::min(memory.wanted_size, control.maximal_size);
    const double size =
      control.automatic ?
        left / std::max(1., std::ceil(left / wanted - rounding_of_size)) :
        std::min(2. * memory.last_size, left);
    const double regular =
      control.automatic ? memory.last_size : control.initial_size;
    return std::abs(size - regular) <= rounding_of_size * regular ? regular :
                                                                    size;
  }



  StepVerdict
  judge_step(const StepControl &control,
             const StepMemory  &memory,
             const StepTrial   &trial)
  {
    if (!trial.converged)
      {
        StepVerdict verdict = refuse(memory, 0.5 * trial.size, "cut in half");
        verdict.memory.patience = std::min(16u, 4 * memory.patience);
        return verdict;
      }
    if (!control.automatic)
      {
        StepVerdict verdict{true, 0., memory, ""};
        verdict.memory.last_size = trial.size;
        return verdict;
      }
    if (trial.error > 1. && !cut_was_useless(trial) &&
        trial.size > (1. + rounding_of_size) * control.minimal_size)
      {
        const double factor = std::max(0.1, safety / std::sqrt(trial.error));
        const double size = std::max(control.minimal_size, factor * trial.size);
        return refuse(memory,
                      size,
                      "error " + as_text(trial.error) +
                        " of the tolerance; cut to " + as_text(size) + " s");
      }
    return accept(control, memory, trial);
  }
} // namespace Signorini
