#include <signorini/input/input_error.h>
#include <signorini/variational_inequality/dual_solver.h>
#include <signorini/variational_inequality/two_step.h>

#include <cmath>
#include <sstream>

namespace Signorini
{
  namespace
  {
    void
    require(const bool         allowed,
            const std::string &entry,
            const double       value,
            const std::string &what)
    {
      if (allowed && std::isfinite(value))
        return;
      std::ostringstream message;
      message << "found " << value << ", but the algorithm `two step' needs "
              << what << ".";
      throw InputError("Contact / " + entry, message.str());
    }
  } // namespace



  TwoStep::TwoStep(const AlternationControl &control)
    : control(control)
  {
    require(control.regularisation_slip >= 0.,
            "Regularisation slip",
            control.regularisation_slip,
            "a length greater than zero, or zero for a choice of its own");
    require(control.force_tolerance > 0.,
            "Force tolerance",
            control.force_tolerance,
            "a number greater than zero");
    require(control.most_alternations > 0,
            "Maximal iterations",
            control.most_alternations,
            "a number greater than zero");
  }



  std::string
  TwoStep::name() const
  {
    return "two step";
  }



  bool
  TwoStep::enforces_exactly() const
  {
    return true;
  }



  InterfaceSolution
  TwoStep::solve_closed(const InterfaceProblem &problem,
                        const InterfaceForces  &starting_forces) const
  {
    refuse_three_dimensional_friction(problem, name());
    return solve_dual_with_friction(
      problem,
      starting_forces,
      [this](const CoulombSystem       &system,
             const std::vector<double> &start,
             DenseFactor               &factor) {
        return solve_coulomb_alternating(system, start, factor, control);
      },
      /*exact=*/false);
  }
} // namespace Signorini
