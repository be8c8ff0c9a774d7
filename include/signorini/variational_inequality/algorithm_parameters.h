#ifndef signorini_variational_inequality_algorithm_parameters_h
#define signorini_variational_inequality_algorithm_parameters_h

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
    std::string  algorithm             = "quadratic programme";
    double       penalty_stiffness     = 0.;    // K_N, N/m
    double       penetration_tolerance = 1e-10; // m
    unsigned int maximal_iterations    = 1000;

    /** Declares the entries in the section that @p prm is in. */
    static void
    declare_parameters(dealii::ParameterHandler &prm);

    /** Reads the entries from the section that @p prm is in. */
    static AlgorithmParameters
    parse(const dealii::ParameterHandler &prm);
  };
} // namespace Signorini

#endif
