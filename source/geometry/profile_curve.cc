#include <signorini/geometry/profile_curve.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    double
    length_of(const CurvePiece &piece)
    {
      return std::visit([](const auto &curve) { return curve.length(); },
                        piece);
    }

    CurvePoint
    point_of(const CurvePiece &piece, const double s)
    {
      return std::visit([&](const auto &curve) { return curve.at(s); }, piece);
    }

    // The closest point of one piece, s in [0, 1]. The pieces turn by less than
    // half a circle, so that the best of a few samples is a good start. Each
    // step goes to the foot of the point on the tangent, which converges
    // quadratically for points on the curve and linearly near it.
    double
    closest_on(const CurvePiece &piece, const Point<2> &p)
    {
      const unsigned int n_samples = 8;
      double best = 0., distance = std::numeric_limits<double>::max();
      for (unsigned int i = 0; i <= n_samples; ++i)
        {
          const double s = i / double(n_samples);
          const double d = point_of(piece, s).position.distance(p);
          if (d < distance)
            {
              best     = s;
              distance = d;
            }
        }

      const double length = length_of(piece);
      if (!(length > 0.))
        return 0.;
      for (unsigned int i = 0; i < 50; ++i)
        {
          const CurvePoint here = point_of(piece, best);
          const double     step = (p - here.position) * here.tangent / length;
          const double     next = std::clamp(best + step, 0., 1.);
          if (std::abs(next - best) < 1e-16)
            break;
          best = next;
        }
      return best;
    }
  } // namespace



  Tensor<1, 2>
  radial(const double angle)
  {
    return Tensor<1, 2>({std::sin(angle), std::cos(angle)});
  }



  Tensor<1, 2>
  across(const double angle)
  {
    return Tensor<1, 2>({std::cos(angle), -std::sin(angle)});
  }



  double
  CircleArc::length() const
  {
    return radius * std::abs(end_angle - start_angle);
  }



  CurvePoint
  CircleArc::at(const double s) const
  {
    const double angle = start_angle + s * (end_angle - start_angle);
    return {center + radius * radial(angle),
            (end_angle < start_angle ? -1. : 1.) * across(angle)};
  }



  double
  StraightFlank::length() const
  {
    return extent;
  }



  CurvePoint
  StraightFlank::at(const double s) const
  {
    const Tensor<1, 2> normal({direction[1], -direction[0]});
    const Tensor<1, 2> slope = extent * direction - 2. * relief * s * normal;
    return {begin + s * extent * direction - relief * s * s * normal,
            slope / slope.norm()};
  }



  double
  InvoluteFlank::length() const
  {
    return (end - begin) * (end + begin) / (2. * base_radius);
  }



  CurvePoint
  InvoluteFlank::at(const double s) const
  {
    const double roll =
      std::sqrt(begin * begin + s * (end - begin) * (end + begin));
    const double fraction = end > begin ? (roll - begin) / (end - begin) : 0.;
    const double angle    = base_angle - roll / base_radius;
    const double height   = roll - relief * fraction * fraction;

    // dx/dg = height/r_b radial - c'(g) across
    Tensor<1, 2> slope = radial(angle);
    if (relief != 0.)
      slope = height / base_radius * radial(angle) -
              2. * relief * fraction / (end - begin) * across(angle);
    return {Point<2>(base_radius * radial(angle) + height * across(angle)),
            slope / slope.norm()};
  }



  double
  TrochoidFillet::length_to(const double tau) const
  {
    const double tangent = std::tan(tau), secant = 1. / std::cos(tau);
    return tip_radius * tau +
           center_depth / pitch_radius *
             (tip_radius * tangent +
              center_depth * (secant * tangent + std::asinh(tangent)) / 2.);
  }



  double
  TrochoidFillet::length() const
  {
    return length_to(end_angle);
  }



  double
  TrochoidFillet::angle_at(const double s) const
  {
    // Newton's method between bounds that close in on the root.
    const double target = s * length();
    double       low = 0., high = end_angle, tau = s * end_angle;
    for (unsigned int i = 0; i < 100; ++i)
      {
        const double error        = length_to(tau) - target;
        (error > 0. ? high : low) = tau;
        const double cosine       = std::cos(tau);
        const double distance     = tip_radius + center_depth / cosine;
        const double speed        = tip_radius + center_depth * distance /
                                            (pitch_radius * cosine * cosine);
        double next = tau - error / speed;
        if (!(next >= low && next <= high))
          next = (low + high) / 2.;
        if (std::abs(next - tau) <= 1e-16)
          break;
        tau = next;
      }
    return tau;
  }



  CurvePoint
  TrochoidFillet::at(const double s) const
  {
    const double tau      = angle_at(s);
    const double distance = tip_radius + center_depth / std::cos(tau);
    const double turn =
      (center_offset - center_depth * std::tan(tau)) / pitch_radius;
    const double angle = space_angle - turn;
    return {Point<2>((pitch_radius - distance * std::cos(tau)) * radial(angle) -
                     distance * std::sin(tau) * across(angle)),
            std::sin(tau) * radial(angle) - std::cos(tau) * across(angle)};
  }



  ProfileCurve::ProfileCurve(std::vector<CurvePiece> pieces)
    : pieces(std::move(pieces))
    , begins(1, 0.)
  {
    for (const CurvePiece &piece : this->pieces)
      begins.push_back(begins.back() + length_of(piece));
  }



  double
  ProfileCurve::length() const
  {
    return begins.back();
  }



  double
  ProfileCurve::begin_of(const unsigned int piece) const
  {
    AssertIndexRange(piece, begins.size());
    return begins[piece];
  }



  const std::vector<CurvePiece> &
  ProfileCurve::get_pieces() const
  {
    return pieces;
  }



  CurvePoint
  ProfileCurve::at(const double l) const
  {
    unsigned int piece = 0;
    while (piece + 1 < pieces.size() && l >= begins[piece + 1])
      ++piece;
    const double length = begins[piece + 1] - begins[piece];
    const double s      = length > 0. ? (l - begins[piece]) / length : 0.;
    return point_of(pieces[piece], std::clamp(s, 0., 1.));
  }



  double
  ProfileCurve::closest(const Point<2> &p) const
  {
    double result = 0., distance = std::numeric_limits<double>::max();
    for (unsigned int piece = 0; piece < pieces.size(); ++piece)
      {
        const double s = closest_on(pieces[piece], p);
        const double d = point_of(pieces[piece], s).position.distance(p);
        if (d < distance)
          {
            distance = d;
            result   = begins[piece] + s * (begins[piece + 1] - begins[piece]);
          }
      }
    return result;
  }
} // namespace Signorini
