#include <signorini/geometry/fir_tree/fir_tree_joint.h>

#include <deal.II/base/parameter_handler.h>

#include <limits>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    void
    declare_teeth(ParameterHandler &prm)
    {
      prm.declare_entry("Teeth",
                        "3",
                        Patterns::Integer(std::numeric_limits<int>::min(), 100),
                        "Number of teeth on each side of the root, n, from 1 "
                        "to 6.");
      prm.declare_entry("Flank length",
                        "0.003",
                        Patterns::Double(),
                        "Length of the straight part of a working flank, l; "
                        "greater than 0. Unit: m.");
      prm.declare_entry(
        "Contact angle",
        "25",
        Patterns::Double(),
        "Angle between the normal of a working flank and the "
        "pull of the blade, alpha, from 5 to 60. Unit: degree.");
      prm.declare_entry("Back flank angle",
                        "35",
                        Patterns::Double(),
                        "Angle between the normal of a back flank, which "
                        "carries nothing, and the pull of the blade, beta, "
                        "from 5 to 70. With the contact angle it makes the "
                        "angle of a tooth, from 30 to 120. Unit: degree.");
      prm.declare_entry("Taper angle",
                        "12",
                        Patterns::Double(),
                        "Half the wedge angle of the root, gamma, from 0 to "
                        "30. The pitch of the teeth follows from the angles, "
                        "the flank length and the radii. Unit: degree.");
    }

    void
    declare_radii(ParameterHandler &prm)
    {
      prm.declare_entry("Root radius",
                        "0.0012",
                        Patterns::Double(),
                        "Radius of the fillets between the teeth of the blade; "
                        "greater than 0. Unit: m.");
      prm.declare_entry("Tip radius",
                        "0.0008",
                        Patterns::Double(),
                        "Radius of the tips of the blade's teeth; greater than "
                        "0. The fillets of the disc around them are larger "
                        "where there is a clearance. Unit: m.");
      prm.declare_entry("Bottom radius",
                        "0.01",
                        Patterns::Double(),
                        "Radius of the lower end of the root, centred on x = "
                        "0; that of the slot is larger by the clearance. "
                        "Unit: m.");
      prm.declare_entry("Bottom neck width",
                        "0.014",
                        Patterns::Double(),
                        "Whole width of the root above its lowest teeth; at "
                        "least twice the root radius. Unit: m.");
      prm.declare_entry("Clearance",
                        "0.0001",
                        Patterns::Double(),
                        "Gap between root and slot everywhere but at the "
                        "working flanks and the arcs next to them, 0 or more. "
                        "Unit: m.");
    }

    void
    declare_disc(ParameterHandler &prm)
    {
      prm.declare_entry("Mouth depth",
                        "0.003",
                        Patterns::Double(),
                        "Length of the straight sides of the slot below the "
                        "rim, measured to the top fillet of the blade; greater "
                        "than 0. Unit: m.");
      prm.declare_entry("Rim radius",
                        "0.28",
                        Patterns::Double(),
                        "Radius of the disc; greater than 0. Unit: m.");
      prm.declare_entry("Blades",
                        "44",
                        Patterns::Integer(std::numeric_limits<int>::min(),
                                          10000),
                        "Number of blades around the disc, at least 3, and so "
                        "few that the slots leave a neck between them.");
    }
  } // namespace



  void
  FirTreeJoint::declare_parameters(ParameterHandler &prm)
  {
    declare_teeth(prm);
    declare_radii(prm);
    declare_disc(prm);
  }
} // namespace Signorini
