#include <signorini/input_error.h>
#include <signorini/variational_inequality/augmented_lagrangian.h>
#include <signorini/variational_inequality/interface_algorithm.h>
#include <signorini/variational_inequality/penalty.h>
#include <signorini/variational_inequality/quadratic_programme.h>

#include <algorithm>
#include <map>

namespace Signorini
{
  namespace
  {
    using Maker =
      std::unique_ptr<InterfaceAlgorithm> (*)(const AlgorithmParameters &);

    // The one list of algorithms, by their .prm names.
    const std::map<std::string, Maker> &
    algorithms()
    {
      static const std::map<std::string, Maker> list = {
        {"augmented Lagrangian",
         [](const AlgorithmParameters &parameters)
           -> std::unique_ptr<InterfaceAlgorithm> {
           return std::make_unique<AugmentedLagrangian>(
             parameters.penalty_stiffness,
             parameters.penetration_tolerance,
             parameters.maximal_iterations);
         }},
        {"penalty",
         [](const AlgorithmParameters &parameters)
           -> std::unique_ptr<InterfaceAlgorithm> {
           return std::make_unique<Penalty>(parameters.penalty_stiffness);
         }},
        {"quadratic programme",
         [](
           const AlgorithmParameters &) -> std::unique_ptr<InterfaceAlgorithm> {
           return std::make_unique<QuadraticProgramme>();
         }}};
      return list;
    }
  } // namespace



  InterfaceSolution
  InterfaceAlgorithm::solve(const InterfaceProblem &problem,
                            const InterfaceForces  &starting_forces) const
  {
    Assert(starting_forces.normal.empty() ||
             starting_forces.normal.size() == problem.n_contacts(),
           dealii::ExcDimensionMismatch(starting_forces.normal.size(),
                                        problem.n_contacts()));
    const std::vector<double> &gaps = problem.free_gaps();
    // False for NaN as well, which the algorithm then refuses.
    if (std::all_of(gaps.begin(), gaps.end(), [](const double gap) {
          return gap >= 0.;
        }))
      {
        InterfaceSolution solution;
        solution.displacement = problem.free_displacement();
        solution.forces       = InterfaceForces(problem.n_contacts());
        return solution;
      }
    return solve_closed(problem, starting_forces);
  }



  std::string
  interface_algorithm_names()
  {
    std::string names;
    for (const auto &[name, maker] : algorithms())
      names += (names.empty() ? "" : "|") + name;
    return names;
  }



  std::unique_ptr<InterfaceAlgorithm>
  make_interface_algorithm(const AlgorithmParameters &parameters)
  {
    const auto algorithm = algorithms().find(parameters.algorithm);
    if (algorithm == algorithms().end())
      throw InputError("Contact / Algorithm: found `" + parameters.algorithm +
                       "', allowed are " + interface_algorithm_names() +
                       ". Choose one of these.");
    return algorithm->second(parameters);
  }
} // namespace Signorini
