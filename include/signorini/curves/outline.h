#ifndef signorini_curves_outline_h
#define signorini_curves_outline_h

#include <signorini/curves/curve.h>

#include <vector>

namespace Signorini
{
  /**
   * A curve drawn from straight lines and circular arcs, each beginning where
   * the last one ended. A cubic cannot be a circle: an arc is cut into pieces
   * of 6 degrees at most, each with p_1 and p_2 on its end tangents at the
   * distance 4/3 tan(angle/4) R, which leaves an error of the radius of at most
   * 2.5e-11 R, outwards.
   */
  class Outline
  {
  public:
    explicit Outline(const dealii::Point<2> &start);

    /** @throws InputError if it would have no length. */
    void
    line_to(const dealii::Point<2> &end);

    /**
     * The arc from here through a point.
     * @throws InputError if the three points lie on a line.
     */
    void
    arc_through(const dealii::Point<2> &middle, const dealii::Point<2> &end);

    /**
     * The arc about a centre, counterclockwise (to the left) or clockwise; a
     * whole circle if it ends where it begins.
     * @throws InputError if the ends are not at the same distance from the
     * centre, to 1e-6 of it.
     */
    void
    arc_about(const dealii::Point<2> &centre,
              const dealii::Point<2> &end,
              const bool              counterclockwise);

    /** Where the drawing ends so far. */
    const dealii::Point<2> &
    end() const
    {
      return end_;
    }

    /**
     * The finished curve. A closed one is drawn back to its start by a straight
     * line if it is not there already.
     * @param feature_angle joints that turn by more are corners, degrees
     * @throws InputError if nothing was drawn.
     */
    Curve
    curve(const bool                     is_closed,
          const double                   feature_angle,
          const std::array<CurveEnd, 2> &ends = {}) const;

  private:
    dealii::Point<2>           start_, end_;
    std::vector<BezierSegment> segments_;
  };

  /** A whole circle, the body within. */
  Curve
  circle(const dealii::Point<2> &centre, const double radius);
} // namespace Signorini

#endif
