#include <signorini/input/input_error.h>
#include <signorini/input/named_errors.h>
#include <signorini/input/regular_file.h>
#include <signorini/variational_inequality/algorithm_comparison.h>
#include <signorini/variational_inequality/interface_algorithm.h>
#include <signorini/variational_inequality/interface_error.h>
#include <signorini/variational_inequality/interface_problem_io.h>
#include <signorini/variational_inequality/kkt_residual.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iomanip>
#include <sstream>

namespace Signorini
{
  namespace
  {
    std::vector<std::string>
    exact_algorithms()
    {
      std::istringstream       names(interface_algorithm_names());
      std::vector<std::string> list;
      AlgorithmParameters      parameters;
      parameters.penalty_stiffness = 1.; // any, to ask them
      while (std::getline(names, parameters.algorithm, '|'))
        if (make_interface_algorithm(parameters)->enforces_exactly())
          list.push_back(parameters.algorithm);
      return list;
    }

    double
    largest_force(const InterfaceForces &forces)
    {
      double largest = 0.;
      for (unsigned int k = 0; k < forces.normal.size(); ++k)
        largest = std::max({largest,
                            std::abs(forces.normal[k]),
                            std::abs(forces.tangential[k][0]),
                            std::abs(forces.tangential[k][1])});
      return largest;
    }

    double
    relative_difference(const InterfaceForces &forces,
                        const InterfaceForces &reference)
    {
      InterfaceForces difference = forces;
      for (unsigned int k = 0; k < forces.normal.size(); ++k)
        {
          difference.normal[k] -= reference.normal[k];
          for (unsigned int j = 0; j < 2; ++j)
            difference.tangential[k][j] -= reference.tangential[k][j];
        }
      const double change = largest_force(difference);
      return change == 0. ? 0. : change / largest_force(reference);
    }
  } // namespace



  std::string
  compare_algorithms(const InterfaceProblem &problem)
  {
    std::ostringstream table;
    table << std::left << std::setw(20) << "algorithm" << std::right
          << std::setw(12) << "iterations" << std::setw(12) << "fallbacks"
          << std::setw(15) << "KKT residual" << std::setw(20)
          << "force difference" << '\n';
    InterfaceForces reference;
    for (const std::string &name : exact_algorithms())
      {
        table << std::left << std::setw(20) << name << std::right;
        try
          {
            AlgorithmParameters parameters;
            parameters.algorithm = name;
            const InterfaceSolution solution =
              make_interface_algorithm(parameters)->solve(problem, {});
            if (reference.normal.empty())
              reference = solution.forces;
            table << std::setw(12) << solution.n_iterations << std::setw(12)
                  << solution.n_fallbacks << std::setprecision(2)
                  << std::scientific << std::setw(15)
                  << kkt_residual(problem, solution).norm() << std::setw(20)
                  << relative_difference(solution.forces, reference) << '\n';
          }
        catch (const InputError &error)
          {
            table << "  " << error.what() << '\n';
          }
        catch (const ComputationError &error)
          {
            table << "  " << error.what() << '\n';
          }
      }
    return table.str();
  }



  std::string
  compare_algorithms_on_file(const std::string &path)
  {
    with_prefix("Interface problem ",
                [&] { require_regular_file(path, largest_data); });
    std::ifstream file(path);
    if (!file)
      throw InputError("Interface problem \"" + path +
                       "\": cannot be read. Does the file exist?");
    const InterfaceProblem problem = read_interface_problem(file, path);
    return path + ": " + std::to_string(problem.size()) + " unknowns, " +
           std::to_string(problem.n_contacts()) + " contacts\n" +
           compare_algorithms(problem);
  }
} // namespace Signorini
