#ifndef signorini_geometry_gears_tooth_row_h
#define signorini_geometry_gears_tooth_row_h

#include <signorini/geometry/gears/gear_tooth.h>

#include <deal.II/base/point.h>

namespace Signorini
{
  /** A point in the frame of one tooth, which points up there. */
  struct ToothPoint
  {
    int              tooth; // from 0
    dealii::Point<2> local; // m
  };

  /**
   * Where the teeth stand, one every `pitch`: around a gear counter-clockwise,
   * or along a rack to the right, pointing up.
   */
  struct ToothRow
  {
    bool             is_round; // a gear, else a rack
    dealii::Point<2> origin;   // m: centre of the gear, or on the pitch line
    double           axis;     // of tooth 0: angle clockwise from y, or x, m
    double           pitch;    // radian, or m
    unsigned int     n_teeth;

    /** All teeth around a gear: no ends. */
    bool
    is_closed() const;

    dealii::Point<2>
    place(const ToothPoint &p) const;

    /** The tooth that @p p is nearest to, by angle or x. */
    ToothPoint
    locate(const dealii::Point<2> &p) const;

    /**
     * A point in the frame of a tooth: @p side from -1 to 1, from the middle of
     * the space on the left to that on the right; @p height is a radius, or y.
     */
    dealii::Point<2>
    local_point(const double side, const double height) const;

    /** The first argument of local_point() for a point. */
    double
    side_of(const dealii::Point<2> &local) const;

    /** Its second argument. */
    double
    height_of(const dealii::Point<2> &local) const;
  };

  /**
   * The profile of a whole row, by one coordinate, an arc length in m. It is 0
   * in the middle of the first tip and grows towards the next tooth.
   */
  class RowProfile
  {
  public:
    RowProfile(const ToothRow &row, const ProfileCurve &half_tooth);

    dealii::Point<2>
    at(const double coordinate) const;

    /** The unit tangent there, in the direction of growing coordinates. */
    dealii::Tensor<1, 2>
    tangent_at(const double coordinate) const;

    /** The coordinate of the point of the profile closest to @p p. */
    double
    closest(const dealii::Point<2> &p) const;

    /** The way from one coordinate to another, the short one around a gear. */
    double
    way(const double from, const double to) const;

  private:
    ToothRow     row;
    ProfileCurve half_tooth;

    CurvePoint
    point_at(const double coordinate) const;
  };
} // namespace Signorini

#endif
