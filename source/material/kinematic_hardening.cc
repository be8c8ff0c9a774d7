#include <signorini/input/input_error.h>
#include <signorini/material/kinematic_hardening.h>

#include <deal.II/base/parameter_handler.h>

namespace Signorini
{
  using namespace dealii;

  void
  KinematicHardening::declare_parameters(ParameterHandler &prm)
  {
    prm.declare_entry("Kinematic hardening",
                      "none",
                      Patterns::Selection("none|linear|Armstrong-Frederick"),
                      "Whether the yield surface also moves with the plastic "
                      "strain, as seen when the load changes its sign.");
    prm.declare_entry("Kinematic hardening modulus",
                      "0",
                      Patterns::Double(),
                      "H_k > 0: in uniaxial tension the centre of the yield "
                      "surface moves with H_k times the plastic strain, at "
                      "first. Unit: Pa.");
    prm.declare_entry("Dynamic recovery",
                      "0",
                      Patterns::Double(),
                      "gamma > 0 of Armstrong-Frederick: the centre of the "
                      "yield surface moves at most by H_k/gamma. Unit: 1.");
  }



  EntryConditions
  KinematicHardening::conditions()
  {
    return {contradiction(read_with({"Kinematic hardening modulus"},
                                    "Kinematic hardening",
                                    {"linear", "Armstrong-Frederick"})),
            contradiction(read_with({"Dynamic recovery"},
                                    "Kinematic hardening",
                                    {"Armstrong-Frederick"}))};
  }



  KinematicHardening
  KinematicHardening::parse(const ParameterHandler &prm)
  {
    const std::string kind = prm.get("Kinematic hardening");
    if (kind == "none")
      return {};
    KinematicHardening hardening;
    hardening.modulus = prm.get_double("Kinematic hardening modulus");
    if (!(hardening.modulus > 0.))
      throw InputError("Kinematic hardening modulus",
                       "must be greater than zero, in Pa, found " +
                         prm.get("Kinematic hardening modulus") +
                         ". Without it set Kinematic hardening = none.");
    if (kind == "linear")
      return hardening;
    hardening.recovery = prm.get_double("Dynamic recovery");
    if (!(hardening.recovery > 0.))
      throw InputError(
        "Dynamic recovery",
        "must be greater than zero, found " + prm.get("Dynamic recovery") +
          ". Without recovery set Kinematic hardening = linear.");
    return hardening;
  }
} // namespace Signorini
