#ifndef signorini_variational_inequality_algorithm_parameters_h
#define signorini_variational_inequality_algorithm_parameters_h

#include <signorini/input/entry_condition.h>

#include <string>

namespace dealii
{
  class ParameterHandler;
}

namespace Signorini
{
  /** Which algorithm solves the interface problems, and its numbers. */
  struct AlgorithmParameters
  {
    std::string algorithm                    = "ando";
    double      penalty_stiffness            = 0.;    // K_N, N/m
    double      tangential_penalty_stiffness = 0.;    // K_T, N/m; 0: K_N
    double      penetration_tolerance        = 1e-10; // m
    double      regularisation_slip          = 0.;    // m; 0: automatic

    // Change of the forces at which two step ends, 1. Far below the 0.01 % of
    // [MC, sec. 5.2]: on the interface that costs next to nothing, and a time
    // step asks for a residual of the order of 1e-9.
    double force_tolerance = 1e-10;

    unsigned int maximal_iterations = 1000;

    /** Declares the entries in the section that @p prm is in. */
    static void
    declare_parameters(dealii::ParameterHandler &prm);

    /** Which entries are read under which choice. */
    static EntryConditions
    conditions();

    /** Reads the entries from the section that @p prm is in. */
    static AlgorithmParameters
    parse(const dealii::ParameterHandler &prm);
  };
} // namespace Signorini

#endif
