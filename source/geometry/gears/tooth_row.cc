#include <signorini/geometry/gears/tooth_row.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>

namespace Signorini
{
  using namespace dealii;

  bool
  ToothRow::is_closed() const
  {
    return is_round && n_teeth * pitch > 2. * numbers::PI - pitch / 2.;
  }



  Point<2>
  ToothRow::place(const ToothPoint &p) const
  {
    if (!is_round)
      return origin + p.local + Point<2>(axis + p.tooth * pitch, 0.);
    const double angle = axis - p.tooth * pitch;
    return origin + p.local[0] * across(angle) + p.local[1] * radial(angle);
  }



  ToothPoint
  ToothRow::locate(const Point<2> &p) const
  {
    const Tensor<1, 2> from_origin = p - origin;
    double             place       = (from_origin[0] - axis) / pitch;
    if (is_round)
      {
        // The angle from the middle of the row, from -pi to pi.
        const double middle = axis - (n_teeth - 1) * pitch / 2.;
        place = (n_teeth - 1) / 2. - std::atan2(from_origin * across(middle),
                                                from_origin * radial(middle)) /
                                       pitch;
      }
    const int tooth =
      std::clamp(static_cast<int>(std::lround(place)), 0, int(n_teeth) - 1);

    if (!is_round)
      return {tooth,
              Point<2>(from_origin[0] - axis - tooth * pitch, from_origin[1])};
    const double angle = axis - tooth * pitch;
    return {tooth,
            Point<2>(from_origin * across(angle), from_origin * radial(angle))};
  }



  Point<2>
  ToothRow::local_point(const double side, const double height) const
  {
    const double distance = side * pitch / 2.;
    return is_round ? Point<2>(height * radial(distance)) :
                      Point<2>(distance, height);
  }



  double
  ToothRow::side_of(const Point<2> &local) const
  {
    return (is_round ? std::atan2(local[0], local[1]) : local[0]) * 2. / pitch;
  }



  double
  ToothRow::height_of(const Point<2> &local) const
  {
    return is_round ? local.norm() : local[1];
  }



  RowProfile::RowProfile(const ToothRow &row, const ProfileCurve &half_tooth)
    : row(row)
    , half_tooth(half_tooth)
  {}



  CurvePoint
  RowProfile::point_at(const double coordinate) const
  {
    const double half  = half_tooth.length();
    const double whole = 2. * half * row.n_teeth;
    const double around =
      row.is_closed() ? std::floor((coordinate + half) / whole) * whole : 0.;
    const double place = (coordinate - around) / (2. * half);
    const int    tooth =
      std::clamp(static_cast<int>(std::lround(place)), 0, int(row.n_teeth) - 1);
    const double ahead = 2. * half * (place - tooth);

    // The next tooth is on the right of a tooth of a rack, but on the left of
    // one of a gear.
    const double side = (ahead < 0.) == row.is_round ? 1. : -1.;

    CurvePoint point =
      half_tooth.at(std::clamp(half - std::abs(ahead), 0., half));
    point.position[0] *= side;
    point.tangent[0] *= side;
    if (ahead > 0.)
      point.tangent *= -1.;

    // A direction turns like the difference of two points.
    const Tensor<1, 2> tangent = row.place({tooth, Point<2>(point.tangent)}) -
                                 row.place({tooth, Point<2>()});
    return {row.place({tooth, point.position}), tangent};
  }



  Point<2>
  RowProfile::at(const double coordinate) const
  {
    return point_at(coordinate).position;
  }



  Tensor<1, 2>
  RowProfile::tangent_at(const double coordinate) const
  {
    return point_at(coordinate).tangent;
  }



  double
  RowProfile::closest(const Point<2> &p) const
  {
    const ToothPoint located = row.locate(p);
    const double     half    = half_tooth.length();
    const double     behind =
      half - half_tooth.closest(
               Point<2>(std::abs(located.local[0]), located.local[1]));
    const bool is_ahead = (located.local[0] < 0.) == row.is_round;
    return 2. * half * located.tooth + (is_ahead ? behind : -behind);
  }



  double
  RowProfile::way(const double from, const double to) const
  {
    const double whole = 2. * half_tooth.length() * row.n_teeth;
    return row.is_closed() ? std::remainder(to - from, whole) : to - from;
  }
} // namespace Signorini
