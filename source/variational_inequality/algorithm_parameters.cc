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
      AlgorithmParameters().algorithm,
      Patterns::Selection(interface_algorithm_names()),
      "How contact and friction forces are found. ando: exactly, by quadratic "
      "programmes with cutting planes for the sign of the slip; in 2-D. two "
      "step: gaps and friction in turns, with friction regularised by the "
      "Regularisation slip; in 2-D. semismooth Newton: exactly, all at once; in "
      "2-D and 3-D. Without friction these three are the same. penalty: force "
      "= Penalty stiffness times penetration or slip. augmented Lagrangian: "
      "penalty, repeated until penetration and slip are below the Penetration "
      "tolerance.");
    prm.declare_entry(
      "Penalty stiffness",
      "0",
      Patterns::Double(0.),
      "Contact force of a node per penetration, K_N. Read by penalty and "
      "augmented Lagrangian, which need a number greater than zero. The "
      "penetration is inversely proportional to it. Unit: N/m (in 2-D per "
      "thickness: N/m^2).");
    prm.declare_entry(
      "Tangential penalty stiffness",
      "0",
      Patterns::Double(0.),
      "Friction force of a node per slip as long as it sticks, K_T. Read by "
      "penalty and augmented Lagrangian. 0: the same as the Penalty stiffness. "
      "Unit: N/m (in 2-D per thickness: N/m^2).");
    prm.declare_entry(
      "Regularisation slip",
      "0",
      Patterns::Double(0.),
      "Slip over a step, epsilon, at which the regularised friction of two "
      "step reaches its bound; up to it, contacts creep where they should "
      "stick. 0: 1e-10 of the displacement of the step. Unit: m.");
    prm.declare_entry(
      "Penetration tolerance",
      "1e-10",
      Patterns::Double(0.),
      "Largest penetration, largest gap under a contact force "
      "and largest error of the slip, at which augmented Lagrangian has converged. "
      "Unit: m.");
    prm.declare_entry("Maximal iterations",
                      "1000",
                      Patterns::Integer(1, 1000000),
                      "Updates of the contact forces after which augmented "
                      "Lagrangian gives up with an error, and two step leaves "
                      "the rest to a slower, safer method. Unit: 1.");
  }



  EntryConditions
  AlgorithmParameters::conditions()
  {
    return {contradiction(
              read_with({"Penalty stiffness", "Tangential penalty stiffness"},
                        "Algorithm",
                        {"penalty", "augmented Lagrangian"})),
            contradiction(
              read_with({"Regularisation slip"}, "Algorithm", {"two step"})),
            contradiction(read_with({"Penetration tolerance"},
                                    "Algorithm",
                                    {"augmented Lagrangian"})),
            contradiction(read_with({"Maximal iterations"},
                                    "Algorithm",
                                    {"augmented Lagrangian", "two step"})),
            read_if_set({"Tangential penalty stiffness", "Regularisation slip"},
                        "Friction coefficient")};
  }



  AlgorithmParameters
  AlgorithmParameters::parse(const ParameterHandler &prm)
  {
    AlgorithmParameters parameters;
    parameters.algorithm         = prm.get("Algorithm");
    parameters.penalty_stiffness = prm.get_double("Penalty stiffness");
    parameters.tangential_penalty_stiffness =
      prm.get_double("Tangential penalty stiffness");
    parameters.regularisation_slip   = prm.get_double("Regularisation slip");
    parameters.penetration_tolerance = prm.get_double("Penetration tolerance");
    parameters.maximal_iterations    = prm.get_integer("Maximal iterations");
    return parameters;
  }
} // namespace Signorini
