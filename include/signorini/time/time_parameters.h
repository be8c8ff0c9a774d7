#ifndef signorini_time_time_parameters_h
#define signorini_time_time_parameters_h

#include <signorini/input/entry_condition.h>
#include <signorini/time/generalized_alpha.h>
#include <signorini/time/step_control.h>

#include <string>

namespace dealii
{
  class ParameterHandler;
}

namespace Signorini
{
  /** How the vibration is taken out of the bodies after a dynamic run. */
  enum class FinalRelaxation
  {
    none,
    still, // one step without inertia
    damped // in motion, which is stopped whenever its energy begins to fall
  };

  /** What a dynamic run starts from. */
  enum class InitialState
  {
    as_given, // the initial displacements, which need not be in balance
    still     // the static equilibrium under the loads at t = 0
  };

  /** Where the mass of nodes that come into contact goes. */
  enum class ContactMass
  {
    consistent,   // it stays
    redistributed // to inner nodes
  };

  /** The section `Time` of the .prm: what is integrated, and how. */
  struct TimeParameters
  {
    bool             dynamic          = true;
    InitialState     initial_state    = InitialState::as_given;
    FinalRelaxation  final_relaxation = FinalRelaxation::none;
    double           end_time;  // s
    double           step_size; // s
    StepControl      step_control;
    GeneralizedAlpha scheme;
    GeneralizedAlpha scheme_with_mass; // after nodes got their mass back
    bool             conserves_energy; // internal forces are those of the step
    ContactMass      contact_mass;
    bool             return_contact_work;
    bool             lump_mass;
    unsigned int     maximal_iterations;
    double           residual_tolerance;

    static void
    declare_parameters(dealii::ParameterHandler &prm);

    /** Which entries are read under which choice. */
    static EntryConditions
    conditions();

    /** All but the scheme. @throws InputError when a combination makes no
     * sense. */
    static TimeParameters
    parse(dealii::ParameterHandler &prm);

    /**
     * The scheme, and which nodes have mass.
     * @param is_large_and_elastic the bodies have finite strains and remember
     *                             nothing: what `automatic' depends on
     * @throws InputError when a combination makes no sense.
     */
    void
    parse_scheme(const bool                is_large_and_elastic,
                 dealii::ParameterHandler &prm);
  };
} // namespace Signorini

#endif
