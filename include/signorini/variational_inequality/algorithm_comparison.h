#ifndef signorini_variational_inequality_algorithm_comparison_h
#define signorini_variational_inequality_algorithm_comparison_h

#include <signorini/variational_inequality/interface_problem.h>

#include <string>

namespace Signorini
{
  /**
   * Solves a problem by every algorithm that enforces its constraints exactly
   * and returns a table: iterations, fallbacks, KKT residual, and the largest
   * difference of a force from those of the first algorithm that found any,
   * relative to their largest. An algorithm that fails says why instead.
   */
  std::string
  compare_algorithms(const InterfaceProblem &problem);

  /**
   * The same for the file @p path, with a line about the problem.
   * @throws InputError if it cannot be read or is no interface problem.
   */
  std::string
  compare_algorithms_on_file(const std::string &path);
} // namespace Signorini

#endif
