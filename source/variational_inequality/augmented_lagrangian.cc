#include <signorini/input_error.h>
#include <signorini/variational_inequality/augmented_lagrangian.h>
#include <signorini/variational_inequality/dual_solver.h>
#include <signorini/variational_inequality/interface_error.h>

#include <cmath>
#include <sstream>

namespace Signorini
{
  namespace
  {
    void
    require_positive(const std::string &entry, const double value)
    {
      if (value > 0. && std::isfinite(value))
        return;
      std::ostringstream message;
      message << "Contact / " << entry << ": found " << value
              << ", but the algorithm `augmented Lagrangian' needs a number "
                 "greater than zero.";
      throw InputError(message.str());
    }
  } // namespace



  AugmentedLagrangian::AugmentedLagrangian(
    const double       stiffness,
    const double       penetration_tolerance,
    const unsigned int maximal_iterations)
    : stiffness(stiffness)
    , penetration_tolerance(penetration_tolerance)
    , maximal_iterations(maximal_iterations)
  {
    require_positive("Penalty stiffness", stiffness);
    require_positive("Penetration tolerance", penetration_tolerance);
    require_positive("Maximal iterations", maximal_iterations);
  }



  std::string
  AugmentedLagrangian::name() const
  {
    return "augmented Lagrangian";
  }



  bool
  AugmentedLagrangian::enforces_exactly() const
  {
    return false;
  }



  InterfaceSolution
  AugmentedLagrangian::solve_closed(
    const InterfaceProblem &problem,
    const InterfaceForces  &starting_forces) const
  {
    std::vector<double> forces = starting_forces.normal;
    forces.resize(problem.n_contacts(), 0.);
    DualTerms terms;
    terms.compliance = 1. / stiffness;
    terms.offsets.resize(problem.n_contacts());

    std::vector<unsigned int> contacts;
    for (unsigned int iteration = 1; iteration <= maximal_iterations;
         ++iteration)
      {
        for (unsigned int k = 0; k < forces.size(); ++k)
          {
            forces[k]        = std::max(forces[k], 0.);
            terms.offsets[k] = forces[k] / stiffness;
          }
        InterfaceSolution solution = solve_dual(problem, forces, terms);
        contacts                   = unsettled(problem, solution);
        if (contacts.empty())
          {
            solution.n_iterations = iteration;
            return solution;
          }
        forces = std::move(solution.forces.normal);
      }

    std::ostringstream message;
    message << "Contact / Algorithm = augmented Lagrangian: after "
            << maximal_iterations
            << " iterations contacts still penetrate, or are open under a "
               "force, by more than the Penetration tolerance of "
            << penetration_tolerance
            << " m. Raise the Penalty stiffness or the tolerance";
    throw InterfaceError(message.str(), contacts);
  }



  std::vector<unsigned int>
  AugmentedLagrangian::unsettled(const InterfaceProblem  &problem,
                                 const InterfaceSolution &solution) const
  {
    std::vector<unsigned int> contacts;
    for (unsigned int k = 0; k < problem.n_contacts(); ++k)
      {
        const double gap = problem.gap_after(k, solution.displacement);
        if (gap < -penetration_tolerance ||
            (solution.forces.normal[k] > 0. && gap > penetration_tolerance))
          contacts.push_back(k);
      }
    return contacts;
  }
} // namespace Signorini
