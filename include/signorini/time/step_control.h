#ifndef signorini_time_step_control_h
#define signorini_time_step_control_h

#include <signorini/input/entry_condition.h>

#include <string>
#include <vector>

namespace dealii
{
  class ParameterHandler;
}

namespace Signorini
{
  /** How the size of a step is chosen: entries of the section `Time`. */
  struct StepControl
  {
    bool                automatic       = false;
    double              initial_size    = 0.; // s; fixed: that of every step
    double              minimal_size    = 0.; // s
    double              maximal_size    = 0.; // s
    double              error_tolerance = 0.; // 1; 0: errors are not estimated
    unsigned int        easy_iterations = 0;  // at most, of an easy step
    std::vector<double> times_to_meet;        // s, increasing

    /** From inside the section. */
    static void
    declare_parameters(dealii::ParameterHandler &prm);

    /** Which entries are read under which choice. */
    static EntryConditions
    conditions();

    /**
     * From inside the section.
     * @throws InputError when a combination makes no sense.
     */
    static StepControl
    parse(const double                    end_time,
          const bool                      dynamic,
          const dealii::ParameterHandler &prm);
  };

  /** What the control remembers from step to step. */
  struct StepMemory
  {
    explicit StepMemory(const double initial_size = 0.)
      : wanted_size(initial_size)
      , last_size(initial_size)
    {}

    double       wanted_size;       // s; steps are shorter to meet a time
    double       last_size;         // s, of the last accepted step
    double       error_rate   = 0.; // of the last steps, error/size^2, 1/s^2
    unsigned int n_easy_steps = 0;  // in a row
    unsigned int patience     = 2;  // easy steps before the size grows

    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int /*version*/)
    {
      archive &wanted_size &last_size &error_rate &n_easy_steps &patience;
    }
  };

  /** A step that converged, or did not. */
  struct StepTrial
  {
    double       size; // s
    bool         converged    = true;
    unsigned int n_iterations = 0;

    /** Estimated error over its tolerance; 0 without an estimate. Then the
     * same of the trial that this one repeats with a smaller size. */
    double error          = 0.;
    double rejected_error = 0.;
  };

  /** What becomes of a trial. */
  struct StepVerdict
  {
    bool        is_accepted;
    double      next_size = 0.; // s, of the repetition of a refused step
    StepMemory  memory;
    std::string reason; // why the size changes, in words; empty: it stays
  };

  /**
   * The size of the next step from a time towards one that has to be met, s.
   *
   * Fixed steps have one size. After a cut they grow by 2 until they have it
   * again, and the last one before the target is shortened.
   *
   * Automatic steps share the way to the target evenly, in as few steps of at
   * most the wanted size as possible. A size that is the last one but for
   * rounding becomes the last one, so that its factor can be used again.
   */
  double
  next_step_size(const StepControl &control,
                 const StepMemory  &memory,
                 const double       time,
                 const double       target);

  /**
   * Accepts a step or refuses it, and tells how the size changes.
   *
   * A step that did not converge is cut in half. With automatic steps
   *  - an error e > 1 (in tolerances) refuses the step. As it falls with the
   *    square of the size, the next trial has 0.8 e^(-1/2) of it. At the
   *    minimal size, or when an earlier cut made the error no smaller, the
   *    step is accepted: a jump does not become smooth in smaller steps;
   *  - after two easy steps in a row the wanted size grows by 2, or less if
   *    the largest error of late, which is forgotten by a tenth with each step,
   *    allows only less. A growth below 1.5 is not worth a new factorisation,
   *    unless it reaches the maximal size;
   *  - a failure makes the next growth wait for up to 16 easy steps, so that a
   *    size that fails again and again is not tried too often.
   */
  StepVerdict
  judge_step(const StepControl &control,
             const StepMemory  &memory,
             const StepTrial   &trial);
} // namespace Signorini

#endif
