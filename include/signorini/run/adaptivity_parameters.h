#ifndef signorini_run_adaptivity_parameters_h
#define signorini_run_adaptivity_parameters_h

#include <signorini/input/entry_condition.h>

#include <string>
#include <vector>

namespace dealii
{
  class ParameterHandler;
}

namespace Signorini
{
  /** The section `Adaptivity`. */
  struct AdaptivityParameters
  {
    unsigned int             maximal_meshes;
    double                   settled_at; // relative change, 1
    std::vector<std::string> quantities; // formulas of check expressions
    double                   error_share;
    unsigned int             cells_across_contact;
    double                   smallest_cell; // m
    unsigned int             maximal_unknowns;
    double                   time;      // s
    double                   step_size; // s; 0: that of the section Time

    static void
    declare_parameters(dealii::ParameterHandler &prm);

    /** Which entries are read under which choice. */
    static EntryConditions
    conditions();

    /** @throws InputError. */
    static AdaptivityParameters
    parse(const double end_time, dealii::ParameterHandler &prm);
  };
} // namespace Signorini

#endif
