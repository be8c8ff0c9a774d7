#ifndef signorini_geometry_gears_rack_tooth_h
#define signorini_geometry_gears_rack_tooth_h

#include <signorini/geometry/gears/gear_tooth.h>

namespace Signorini
{
  /**
   * A tooth of the rack that a gear with this profile shift meshes with. The
   * origin is on the pitch line, which rolls on the pitch circle of the gear.
   *
   * The datum line, where teeth and spaces are equally wide, lies x m below
   * the pitch line. From the datum line, the tip is addendum m above and the
   * root dedendum m below. The thickness on the pitch line is m (pi/2 - 2 x
   * tan(alpha)) - thinning. The fillets are arcs with the radius fillet_radius
   * m, tangent to flank and root. Source: ISO 53.
   *
   * relief_length is measured along the flank, back from the tip.
   */
  class RackTooth
  {
  public:
    explicit RackTooth(const ToothParameters &parameters);

    /** y of the tip, m. */
    double
    tip_height() const;

    /** y of the root, m. */
    double
    root_height() const;

    /** Thickness on the pitch line, m. */
    double
    pitch_thickness() const;

    /** Width of the tip, m; not positive for a pointed tooth. */
    double
    tip_thickness() const;

    /** Half the width of the root between the fillets, m; may be negative. */
    double
    half_land_of_root() const;

    double
    largest_fillet_radius() const;

    /** y where the flank begins above the fillet, m. */
    double
    begin_of_flank() const;

    /** Length of the straight flank without tip relief, m. */
    double
    flank_length() const;

    HalfTooth
    half_tooth() const;

  private:
    ToothParameters parameters;

    dealii::Point<2>
    on_flank(const double y) const;
  };
} // namespace Signorini

#endif
