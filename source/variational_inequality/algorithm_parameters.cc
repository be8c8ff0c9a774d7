#include <signorini/variational_inequality/algorithm_parameters.h>
#include <signorini/variational_inequality/interface_algorithm.h>

#include <deal.II/base/parameter_handler.h>

namespace Signorini
{
  using namespace dealii;

  void
  AlgorithmParameters::declare_parameters(ParameterHandler &prm)
  {
    prm.declare_entry(
      "Algorithm",
      "quadratic programme",
      Patterns::Selection(interface_algorithm_names()),
      "How contact forces are found. quadratic programme: exactly, from the "
      "gap constraints. penalty: force = Penalty stiffness times penetration. "
      "augmented Lagrangian: penalty, repeated until the penetration is below "
      "the Penetration tolerance.");
    prm.declare_entry(
      "Penalty stiffness",
      "0",
      Patterns::Double(0.),
      "Contact force of a node per penetration, K_N. Read by penalty and "
      "augmented Lagrangian, which need a number greater than zero. The "
      "penetration is inversely proportional to it. Unit: N/m (in 2-D per "
      "thickness: N/m^2).");
    prm.declare_entry("Penetration tolerance",
                      "1e-10",
                      Patterns::Double(0.),
                      "Largest penetration, and largest gap under a contact "
                      "force, at which augmented Lagrangian has converged. "
                      "Unit: m.");
    prm.declare_entry("Maximal iterations",
                      "1000",
                      Patterns::Integer(1),
                      "Updates of the contact forces after which augmented "
                      "Lagrangian gives up with an error. Unit: 1.");
  }



  AlgorithmParameters
  AlgorithmParameters::parse(const ParameterHandler &prm)
  {
    AlgorithmParameters parameters;
    parameters.algorithm             = prm.get("Algorithm");
    parameters.penalty_stiffness     = prm.get_double("Penalty stiffness");
    parameters.penetration_tolerance = prm.get_double("Penetration tolerance");
    parameters.maximal_iterations    = prm.get_integer("Maximal iterations");
    return parameters;
  }
} // namespace Signorini
