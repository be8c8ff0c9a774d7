#ifndef signorini_run_pair_parameters_h
#define signorini_run_pair_parameters_h

#include <signorini/contact/contact_law.h>
#include <signorini/contact/contact_model.h>
#include <signorini/contact/surface_interpolation.h>
#include <signorini/input/entry_condition.h>
#include <signorini/input/space_time_function.h>

#include <optional>
#include <string>
#include <vector>

namespace Signorini
{
  /** What becomes of a contactor node that lies inside of its target at t = 0.
   */
  enum class Overclosure
  {
    refuse,    // it is an error
    press_fit, // it is pushed out with strain, over a ramp in time
    adjust     // its gap counts from there, without strain
  };

  /**
   * How a pair touches. The section `Contact' has the entries for all pairs; a
   * section `Pair TEXT' in it, with the text of the pair as in the list, those
   * that are different for this one.
   */
  struct PairParameters
  {
    ContactLaw law;

    // None: what the meshes ask for, see constraint_for().
    std::optional<ContactConstraint> constraint;

    SurfaceInterpolation surface;
    Overclosure          overclosure   = Overclosure::refuse;
    double               press_fit_end = 1.; // s

    /** Declares the entries of the section `Contact' and of those in it. */
    static void
    declare_parameters(const std::vector<std::string> &pairs,
                       dealii::ParameterHandler       &prm);

    /** Which entries are read under which choice. */
    static EntryConditions
    conditions();

    /** Reads those of a pair, from inside of `Contact'. @throws InputError. */
    static PairParameters
    parse(const std::string        &pair,
          const Constants          &constants,
          dealii::ParameterHandler &prm);
  };
} // namespace Signorini

#endif
