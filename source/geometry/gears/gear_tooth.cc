#include <signorini/geometry/degrees.h>
#include <signorini/geometry/gears/gear_tooth.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    // Involute function tan(angle) - angle.
    double
    inv(const double angle)
    {
      return std::tan(angle) - angle;
    }

    double
    radian(const double degrees)
    {
      return degrees * numbers::PI / 180.;
    }
  } // namespace



  GearTooth::GearTooth(const unsigned int     n_teeth,
                       const ToothParameters &parameters)
    : n_teeth(n_teeth)
    , parameters(parameters)
  {}



  double
  GearTooth::pitch_radius() const
  {
    return parameters.module * n_teeth / 2.;
  }



  double
  GearTooth::base_radius() const
  {
    return pitch_radius() * cos_degrees(parameters.pressure_angle);
  }



  double
  GearTooth::tip_radius() const
  {
    return pitch_radius() +
           parameters.module * (parameters.addendum + parameters.profile_shift);
  }



  double
  GearTooth::root_radius() const
  {
    return pitch_radius() -
           parameters.module * (parameters.dedendum - parameters.profile_shift);
  }



  double
  GearTooth::pitch_thickness() const
  {
    return parameters.module * (numbers::PI / 2. +
                                2. * parameters.profile_shift *
                                  std::tan(radian(parameters.pressure_angle))) -
           parameters.thinning;
  }



  double
  GearTooth::tip_thickness() const
  {
    if (!(tip_radius() > base_radius()))
      return 0.;
    const double   roll_end = end_of_involute() + parameters.relief;
    const Point<2> corner =
      flank(0., roll_end, parameters.relief).at(1.).position;
    return 2. * tip_radius() * std::atan2(corner[0], corner[1]);
  }



  double
  GearTooth::rounding_depth() const
  {
    return parameters.module * (parameters.dedendum - parameters.profile_shift -
                                parameters.fillet_radius);
  }



  double
  GearTooth::half_land_of_cutter() const
  {
    // The centre of the rounding, whose circle touches the flank of the cutter.
    const double alpha = radian(parameters.pressure_angle);
    return (numbers::PI * parameters.module - pitch_thickness()) / 2. -
           rounding_depth() * std::tan(alpha) -
           parameters.module * parameters.fillet_radius / std::cos(alpha);
  }



  double
  GearTooth::largest_fillet_radius() const
  {
    const double alpha = radian(parameters.pressure_angle);
    return parameters.fillet_radius +
           half_land_of_cutter() /
             (parameters.module * (1. / std::cos(alpha) - std::tan(alpha)));
  }



  double
  GearTooth::smallest_profile_shift() const
  {
    const double sine = sin_degrees(parameters.pressure_angle);
    return parameters.dedendum - parameters.fillet_radius * (1. - sine) -
           n_teeth / 2. * sine * sine;
  }



  double
  GearTooth::begin_of_involute() const
  {
    const double sine = sin_degrees(parameters.pressure_angle);
    return pitch_radius() * sine - rounding_depth() / sine -
           parameters.module * parameters.fillet_radius;
  }



  double
  GearTooth::end_of_involute() const
  {
    return std::sqrt((tip_radius() + base_radius()) *
                     (tip_radius() - base_radius()));
  }



  InvoluteFlank
  GearTooth::flank(const double begin,
                   const double end,
                   const double relief) const
  {
    return {base_radius(),
            pitch_thickness() / (2. * pitch_radius()) +
              inv(radian(parameters.pressure_angle)),
            begin,
            end,
            relief};
  }



  TrochoidFillet
  GearTooth::fillet() const
  {
    return {pitch_radius(),
            numbers::PI / n_teeth,
            half_land_of_cutter(),
            rounding_depth(),
            parameters.module * parameters.fillet_radius,
            radian(90. - parameters.pressure_angle)};
  }



  HalfTooth
  GearTooth::half_tooth() const
  {
    const double roll_begin  = begin_of_involute();
    const double roll_relief = end_of_involute() - parameters.relief_length;
    const double roll_end    = end_of_involute() + parameters.relief;
    const double half_tip    = tip_thickness() / (2. * tip_radius());
    const TrochoidFillet trochoid  = fillet();
    const double         half_land = trochoid.center_offset / pitch_radius();

    std::vector<CurvePiece> pieces = {CircleArc{Point<2>(),
                                                root_radius(),
                                                trochoid.space_angle,
                                                trochoid.space_angle -
                                                  half_land},
                                      trochoid};
    if (parameters.relief > 0.)
      {
        pieces.push_back(flank(roll_begin, roll_relief, 0.));
        pieces.push_back(flank(roll_relief, roll_end, parameters.relief));
      }
    else
      pieces.push_back(flank(roll_begin, roll_end, 0.));
    pieces.push_back(CircleArc{Point<2>(), tip_radius(), half_tip, 0.});

    const ProfileCurve profile(pieces);
    return {profile,
            profile.begin_of(1) +
              trochoid.length_to(
                std::min(radian(50.), 0.75 * trochoid.end_angle)),
            profile.begin_of(2),
            profile.begin_of(pieces.size() - 1)};
  }
} // namespace Signorini
