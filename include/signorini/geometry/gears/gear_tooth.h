#ifndef signorini_geometry_gears_gear_tooth_h
#define signorini_geometry_gears_gear_tooth_h

#include <signorini/geometry/profile_curve.h>

namespace Signorini
{
  /**
   * What the teeth of a gear and of a rack have in common. The coefficients
   * are multiples of the module, as those of the basic rack of ISO 53.
   */
  struct ToothParameters
  {
    double module         = 1.;   // m
    double pressure_angle = 20.;  // degrees
    double addendum       = 1.;   // coefficient
    double dedendum       = 1.25; // coefficient
    double profile_shift  = 0.;   // coefficient, of the gear
    double fillet_radius  = 0.38; // coefficient
    double thinning       = 0.;   // m, on the pitch line
    double relief         = 0.;   // m, normal to the flank, at the tip
    double relief_length  = 0.;   // m
  };

  /**
   * The right half of a tooth that points up, along the y axis.
   *
   * The profile goes from the middle of the space on the right, up the right
   * flank, to the middle of the tip. Numbers are arc lengths.
   */
  struct HalfTooth
  {
    ProfileCurve profile;
    double fillet_middle; // where the tangent has turned by some 50 degrees
    double flank_begin;   // the fillet ends, the flank begins
    double flank_end;     // the corner of the tip
  };

  /**
   * A tooth of a spur gear, exactly as a rack-type cutter makes it whose pitch
   * line rolls on the pitch circle, r = m z/2; only the tip circle and the tip
   * relief are added. The origin is the centre of the gear.
   *
   * With the module m, the pressure angle alpha and the shift x: tip radius r +
   * (addendum + x) m, root radius r - (dedendum - x) m, thickness on the pitch
   * circle m (pi/2 + 2 x tan(alpha)) - thinning. The tip of the cutter is
   * rounded with fillet_radius m. Source: ISO 53, ISO 21771, 4.2 and 5.
   *
   * relief_length is measured along the line of action, back from the end of
   * the contact at the tip.
   */
  class GearTooth
  {
  public:
    GearTooth(const unsigned int n_teeth, const ToothParameters &parameters);

    double
    pitch_radius() const;

    double
    base_radius() const;

    double
    tip_radius() const;

    double
    root_radius() const;

    /** Thickness on the pitch circle, an arc length, m. */
    double
    pitch_thickness() const;

    /** Length of the arc at the tip, m; not positive for a pointed tooth. */
    double
    tip_thickness() const;

    /**
     * Half the length of the flat tip of the cutter, m. Negative when the
     * rounding is too large for it.
     */
    double
    half_land_of_cutter() const;

    /** The largest fillet_radius for which the cutter has its full depth. */
    double
    largest_fillet_radius() const;

    /** With less profile shift, the cutter cuts away a part of the involute. */
    double
    smallest_profile_shift() const;

    /** The roll length where the involute begins, m; negative: undercut. */
    double
    begin_of_involute() const;

    /** The roll length at the tip circle without tip relief, m. */
    double
    end_of_involute() const;

    /** For a tooth that is neither undercut nor pointed. */
    HalfTooth
    half_tooth() const;

  private:
    unsigned int    n_teeth;
    ToothParameters parameters;

    double
    rounding_depth() const;

    InvoluteFlank
    flank(const double begin, const double end, const double relief) const;

    TrochoidFillet
    fillet() const;
  };
} // namespace Signorini

#endif
