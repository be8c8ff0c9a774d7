#ifndef signorini_geometry_profile_curve_h
#define signorini_geometry_profile_curve_h

#include <deal.II/base/point.h>

#include <utility>
#include <variant>
#include <vector>

/**
 * The curves that the profiles of gear teeth consist of. Each is the image of
 * s in [0, 1], where s is the fraction of its length.
 *
 * Angles of a profile are measured clockwise from the y axis: with
 * radial(t) = (sin t, cos t) and across(t) = (cos t, -sin t), a tooth that
 * points up has its right flank at positive angles.
 */
namespace Signorini
{
  /** A point of a curve and the unit tangent there, in the sense of s. */
  struct CurvePoint
  {
    dealii::Point<2>     position; // m
    dealii::Tensor<1, 2> tangent;
  };

  dealii::Tensor<1, 2>
  radial(const double angle);

  dealii::Tensor<1, 2>
  across(const double angle);

  /** Part of a circle; the end may be less than the start. */
  struct CircleArc
  {
    dealii::Point<2> center;      // m
    double           radius;      // m
    double           start_angle; // radian
    double           end_angle;   // radian

    double
    length() const;

    CurvePoint
    at(const double s) const;
  };

  /**
   * A straight flank with the unit tangent e, and n to its right: x(t) = begin
   * + t e - relief (t/extent)^2 n for t in [0, extent]. With a relief, the
   * parabola leaves the line without a kink.
   */
  struct StraightFlank
  {
    dealii::Point<2>     begin; // m
    dealii::Tensor<1, 2> direction;
    double               extent; // m
    double               relief; // m, by how much the end is set back

    double
    length() const;

    CurvePoint
    at(const double s) const;
  };

  /**
   * An involute of the circle with the radius r_b around the origin: with the
   * roll length g (the length of the tangent to the base circle) and t =
   * base_angle - g/r_b,
   *
   *   x(g) = r_b radial(t) + (g - c(g)) across(t),
   *
   * and c = 0 for the involute itself; else the profile is set back along its
   * normal by c(g) = relief ((g - begin)/(end - begin))^2. The length is
   * (end^2 - begin^2)/(2 r_b), and that of the modified part deviates from it
   * by a fraction of about relief/end.
   *
   * Source: ISO 21771, 5.2 (involute), 6 (tip relief).
   */
  struct InvoluteFlank
  {
    double base_radius; // m
    double base_angle;  // radian, where the involute meets the base circle
    double begin;       // m, roll length, not negative
    double end;         // m, roll length
    double relief;      // m, at the end

    double
    length() const;

    CurvePoint
    at(const double s) const;
  };

  /**
   * The fillet cut by the rounded tip of a rack that rolls on the pitch circle.
   *
   * The centre of the rounding lies at a = center_offset from the middle of the
   * space and b = center_depth below the pitch line; rho is its radius. It
   * touches the fillet where the normal goes through the pitch point. With the
   * angle tau between the tangent and the pitch line and the distance D = rho +
   * b/cos(tau) from the pitch point, the gear stands turned by phi = (a - b
   * tan(tau))/r, and in the tooth's own frame, with t = space_angle - phi,
   *
   *   x(tau) = (r - D cos(tau)) radial(t) - D sin(tau) across(t),
   *   |dx/dtau| = rho + b D/(r cos^2(tau)).
   *
   * tau goes from 0, at the root circle, to pi/2 - pressure angle, where the
   * involute begins with the same tangent. Source: Litvin and Fuentes, Gear
   * Geometry and Applied Theory, chapters 6 (envelopes) and 10 (rack cutters).
   */
  struct TrochoidFillet
  {
    double pitch_radius;  // m
    double space_angle;   // radian, from the axis of the tooth
    double center_offset; // m
    double center_depth;  // m
    double tip_radius;    // m
    double end_angle;     // radian, the last tau

    /** The length from the root circle to @p tau. */
    double
    length_to(const double tau) const;

    /** tau at this fraction of the length. */
    double
    angle_at(const double s) const;

    double
    length() const;

    CurvePoint
    at(const double s) const;
  };

  using CurvePiece =
    std::variant<CircleArc, StraightFlank, InvoluteFlank, TrochoidFillet>;

  /**
   * Pieces one after the other, by the arc length l from the first point. They
   * are to meet; a corner is allowed.
   */
  class ProfileCurve
  {
  public:
    explicit ProfileCurve(std::vector<CurvePiece> pieces);

    double
    length() const;

    /** Arc length up to the first point of a piece. */
    double
    begin_of(const unsigned int piece) const;

    const std::vector<CurvePiece> &
    get_pieces() const;

    /** The point at @p l from 0 to length(). */
    CurvePoint
    at(const double l) const;

    /** The arc length of the closest point. */
    double
    closest(const dealii::Point<2> &p) const;

  private:
    std::vector<CurvePiece> pieces;
    std::vector<double>     begins; // of the pieces, and the whole length
  };
} // namespace Signorini

#endif
