#include <signorini/input/input_error.h>
#include <signorini/variational_inequality/augmented_lagrangian.h>
#include <signorini/variational_inequality/coulomb_fallback.h>
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
      message << "found " << value
              << ", but the algorithm `augmented Lagrangian' needs a number "
                 "greater than zero.";
      throw InputError("Contact / " + entry, message.str());
    }
  } // namespace



  AugmentedLagrangian::AugmentedLagrangian(
    const double       stiffness,
    const double       penetration_tolerance,
    const unsigned int maximal_iterations,
    const double       tangential_stiffness)
    : stiffness(stiffness)
    , tangential_stiffness(tangential_stiffness == 0. ? stiffness :
                                                        tangential_stiffness)
    , penetration_tolerance(penetration_tolerance)
    , maximal_iterations(maximal_iterations)
  {
    require_positive("Penalty stiffness", stiffness);
    require_positive("Tangential penalty stiffness",
                     this->tangential_stiffness);
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
    InterfaceForces forces = starting_forces;
    forces.normal.resize(problem.n_contacts(), 0.);
    forces.tangential.resize(problem.n_contacts(), {{0., 0.}});
    DualTerms terms;
    terms.compliance            = 1. / stiffness;
    terms.tangential_compliance = 1. / tangential_stiffness;
    terms.offsets.resize(problem.n_contacts());
    terms.slip_offsets.resize(problem.n_contacts());

    unsigned int              n_fallbacks = 0;
    std::vector<unsigned int> fallback_contacts;

    std::vector<unsigned int> contacts;
    for (unsigned int iteration = 1; iteration <= maximal_iterations;
         ++iteration)
      {
        for (unsigned int k = 0; k < problem.n_contacts(); ++k)
          {
            forces.normal[k] = std::max(forces.normal[k], 0.);
            terms.offsets[k] = forces.normal[k] / stiffness;
            for (unsigned int j = 0; j < 2; ++j)
              terms.slip_offsets[k][j] =
                forces.tangential[k][j] / tangential_stiffness;
          }
        InterfaceSolution solution = solve_dual_with_friction(
          problem, forces, solve_coulomb, /*exact=*/true, terms);
        n_fallbacks += solution.n_fallbacks;
        fallback_contacts.insert(fallback_contacts.end(),
                                 solution.fallback_contacts.begin(),
                                 solution.fallback_contacts.end());
        contacts = unsettled(problem, forces, solution);
        if (contacts.empty())
          {
            solution.n_iterations      = iteration;
            solution.n_fallbacks       = n_fallbacks;
            solution.fallback_contacts = std::move(fallback_contacts);
            return solution;
          }
        forces = std::move(solution.forces);
      }

    std::ostringstream message;
    message
      << "Contact / Algorithm = augmented Lagrangian: after "
      << maximal_iterations
      << " iterations contacts still penetrate, are open under a force "
         "or slip where they should stick, by more than the Penetration tolerance of "
      << penetration_tolerance
      << " m. Raise the Penalty stiffness or the tolerance";
    throw InterfaceError(message.str(), contacts);
  }



  std::vector<unsigned int>
  AugmentedLagrangian::unsettled(const InterfaceProblem  &problem,
                                 const InterfaceForces   &old_forces,
                                 const InterfaceSolution &solution) const
  {
    std::vector<unsigned int> contacts;
    for (unsigned int k = 0; k < problem.n_contacts(); ++k)
      {
        const double gap  = problem.gap_after(k, solution.displacement);
        const double slip = std::hypot(solution.forces.tangential[k][0] -
                                         old_forces.tangential[k][0],
                                       solution.forces.tangential[k][1] -
                                         old_forces.tangential[k][1]) /
                            tangential_stiffness;
        if (gap < -penetration_tolerance ||
            (solution.forces.normal[k] > 0. && gap > penetration_tolerance) ||
            slip > penetration_tolerance)
          contacts.push_back(k);
      }
    return contacts;
  }
} // namespace Signorini
