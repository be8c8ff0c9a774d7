#include <signorini/input/input_error.h>
#include <signorini/variational_inequality/ando.h>
#include <signorini/variational_inequality/augmented_lagrangian.h>
#include <signorini/variational_inequality/interface_algorithm.h>
#include <signorini/variational_inequality/penalty.h>
#include <signorini/variational_inequality/semismooth_newton.h>
#include <signorini/variational_inequality/two_step.h>

#include <algorithm>
#include <utility>

namespace Signorini
{
  namespace
  {
    using Maker =
      std::unique_ptr<InterfaceAlgorithm> (*)(const AlgorithmParameters &);

    // The one list of algorithms, by their .prm names.
    const std::vector<std::pair<std::string, Maker>> &
    algorithms()
    {
      static const std::vector<std::pair<std::string, Maker>> list = {
        {"ando",
         [](
           const AlgorithmParameters &) -> std::unique_ptr<InterfaceAlgorithm> {
           return std::make_unique<Ando>();
         }},
        {"two step",
         [](const AlgorithmParameters &parameters)
           -> std::unique_ptr<InterfaceAlgorithm> {
           return std::make_unique<TwoStep>(
             AlternationControl{parameters.regularisation_slip,
                                parameters.force_tolerance,
                                parameters.maximal_iterations});
         }},
        {"semismooth Newton",
         [](
           const AlgorithmParameters &) -> std::unique_ptr<InterfaceAlgorithm> {
           return std::make_unique<SemismoothNewton>();
         }},
        {"penalty",
         [](const AlgorithmParameters &parameters)
           -> std::unique_ptr<InterfaceAlgorithm> {
           return std::make_unique<Penalty>(
             parameters.penalty_stiffness,
             parameters.tangential_penalty_stiffness);
         }},
        {"augmented Lagrangian",
         [](const AlgorithmParameters &parameters)
           -> std::unique_ptr<InterfaceAlgorithm> {
           return std::make_unique<AugmentedLagrangian>(
             parameters.penalty_stiffness,
             parameters.penetration_tolerance,
             parameters.maximal_iterations,
             parameters.tangential_penalty_stiffness);
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
        solution.is_slipping.resize(problem.n_contacts());
        return solution;
      }
    return solve_closed(problem, starting_forces);
  }



  void
  refuse_three_dimensional_friction(const InterfaceProblem &problem,
                                    const std::string      &name)
  {
    for (unsigned int k = 0; k < problem.n_contacts(); ++k)
      if (problem.contact(k).has_friction() &&
          problem.contact(k).tangents.size() > 1)
        throw InputError::of_value(
          "Contact / Algorithm",
          name,
          "it needs a slip with a sign, as in two dimensions, "
          "but there is friction in three. Use `semismooth "
          "Newton'.");
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
    for (const auto &[name, maker] : algorithms())
      if (name == parameters.algorithm)
        return maker(parameters);
    throw InputError("Contact / Algorithm",
                     "found `" + parameters.algorithm + "', allowed are " +
                       interface_algorithm_names() + ". Choose one of these.");
  }
} // namespace Signorini
