#ifndef signorini_geometry_fir_tree_fir_tree_joint_h
#define signorini_geometry_fir_tree_fir_tree_joint_h

#include <string>

namespace dealii
{
  class ParameterHandler;
}

namespace Signorini
{
  class Entries;

  /**
   * The measures of a fir-tree joint: a blade root with teeth on both sides in
   * a slot of a turbine disc, symmetric about the y axis. The axis of the disc
   * is the origin, the blade is pulled along +y. Tooth 1 is the one nearest the
   * rim.
   *
   * [MC, sec. 6.3] names the features n, l, alpha, beta and gamma, the last
   * two of which "define the tooth pitch"; its figure 21 is not in the text.
   * They are read so:
   *  - n: teeth on each side of the root.
   *  - l: length of the straight part of a working flank.
   *  - alpha: between the normal of a working flank and the pull of the blade
   *    (so also between the flank and the tangent of the rim).
   *  - beta: the same for the back flank, which carries nothing; alpha + beta
   *    is the angle between the two flanks of a tooth.
   *  - gamma: half the wedge angle of the root; each tooth is moved from the
   *    one above by the pitch p along (-sin gamma, -cos gamma).
   *
   * With R = root radius + tip radius, the chain of flank, tip, back flank and
   * fillet closes on the next tooth for exactly one length m of the back flank
   * and one pitch:
   *
   *     m = {l cos(alpha-gamma) + R [sin(beta+gamma) - sin(alpha-gamma)]}
   *         / cos(beta+gamma)
   *     p = {l sin(alpha+beta) + R [1 + cos(alpha+beta)]} / cos(beta+gamma)
   */
  struct FirTreeJoint
  {
    unsigned int n_teeth;           // n, on each side
    double       flank_length;      // l, m
    double       contact_angle;     // alpha, degrees
    double       back_angle;        // beta, degrees
    double       taper_angle;       // gamma, degrees
    double       root_radius;       // of the fillets between the teeth, m
    double       tip_radius;        // of the tips of the blade's teeth, m
    double       bottom_radius;     // of the root's lower end, m
    double       bottom_neck_width; // whole width of the root, m
    double       clearance;         // m
    double       mouth_depth;       // m
    double       rim_radius;        // m
    unsigned int n_blades;          // around the disc

    /** Declares the entries of the joint, which blade and disc share. */
    static void
    declare_parameters(dealii::ParameterHandler &prm);

    /** @throws InputError also for measures that make no joint. */
    void
    parse_parameters(const Entries &entries);

    /** Distance between neighbouring teeth, p. Unit: m. */
    double
    pitch() const;

    /** Length of the straight part of a back flank, m. Unit: m. */
    double
    back_flank_length() const;

    /** Angle by which the surface turns at a tip. Unit: degree. */
    double
    tip_turn() const;

    /** Half the width of the root at the fillet above a tooth. Unit: m. */
    double
    neck(const unsigned int tooth) const;

    /**
     * By how much the radii of two arcs, tangent to each other at the end of a
     * working flank, differ so that they are the clearance c apart where they
     * have turned by @p angle: c / (1 - cos angle). Unit: m.
     */
    double
    radius_difference(const double angle) const;
  };

  /** The number in four digits, rounded down: still within a limit above. */
  std::string
  limit_in_words(const double limit);
} // namespace Signorini

#endif
