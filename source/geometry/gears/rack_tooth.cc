#include <signorini/geometry/degrees.h>
#include <signorini/geometry/gears/rack_tooth.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    double
    tan_degrees(const double angle)
    {
      return sin_degrees(angle) / cos_degrees(angle);
    }
  } // namespace



  RackTooth::RackTooth(const ToothParameters &parameters)
    : parameters(parameters)
  {}



  double
  RackTooth::tip_height() const
  {
    return parameters.module * (parameters.addendum - parameters.profile_shift);
  }



  double
  RackTooth::root_height() const
  {
    return -parameters.module *
           (parameters.dedendum + parameters.profile_shift);
  }



  double
  RackTooth::pitch_thickness() const
  {
    return parameters.module *
             (numbers::PI / 2. - 2. * parameters.profile_shift *
                                   tan_degrees(parameters.pressure_angle)) -
           parameters.thinning;
  }



  double
  RackTooth::tip_thickness() const
  {
    // The end of the relief lies relief/cos(alpha) beside the straight flank.
    return 2. * (on_flank(tip_height())[0] -
                 parameters.relief / cos_degrees(parameters.pressure_angle));
  }



  double
  RackTooth::half_land_of_root() const
  {
    const double radius = parameters.module * parameters.fillet_radius;
    return numbers::PI * parameters.module / 2. -
           on_flank(begin_of_flank())[0] -
           radius * cos_degrees(parameters.pressure_angle);
  }



  double
  RackTooth::largest_fillet_radius() const
  {
    const double alpha = parameters.pressure_angle;
    return parameters.fillet_radius +
           half_land_of_root() / (parameters.module * (1. / cos_degrees(alpha) -
                                                       tan_degrees(alpha)));
  }



  double
  RackTooth::begin_of_flank() const
  {
    return root_height() + parameters.module * parameters.fillet_radius *
                             (1. - sin_degrees(parameters.pressure_angle));
  }



  double
  RackTooth::flank_length() const
  {
    return (tip_height() - begin_of_flank()) /
           cos_degrees(parameters.pressure_angle);
  }



  Point<2>
  RackTooth::on_flank(const double y) const
  {
    return {pitch_thickness() / 2. - y * tan_degrees(parameters.pressure_angle),
            y};
  }



  HalfTooth
  RackTooth::half_tooth() const
  {
    const double       alpha  = parameters.pressure_angle;
    const double       radius = parameters.module * parameters.fillet_radius;
    const Tensor<1, 2> upward({-sin_degrees(alpha), cos_degrees(alpha)});
    const Tensor<1, 2> outward({cos_degrees(alpha), sin_degrees(alpha)});
    const Point<2>     begin  = on_flank(begin_of_flank());
    const Point<2>     center = begin + radius * outward;
    const Point<2>     middle_of_space(numbers::PI * parameters.module / 2.,
                                   root_height());

    // The arc goes from straight below its centre, pi, on to the flank.
    const double            start_angle = numbers::PI;
    const double            end_angle   = (270. - alpha) * numbers::PI / 180.;
    std::vector<CurvePiece> pieces      = {
           StraightFlank{
        middle_of_space, Tensor<1, 2>({-1., 0.}), half_land_of_root(), 0.},
           CircleArc{center, radius, start_angle, end_angle}};

    const double relief = parameters.relief;
    const double full =
      flank_length() - (relief > 0. ? parameters.relief_length : 0.);
    pieces.push_back(StraightFlank{begin, upward, full, 0.});
    if (relief > 0.)
      pieces.push_back(
        StraightFlank{begin + full * upward,
                      upward,
                      parameters.relief_length + relief * tan_degrees(alpha),
                      relief});
    const Point<2> corner(tip_thickness() / 2., tip_height());
    pieces.push_back(
      StraightFlank{corner, Tensor<1, 2>({-1., 0.}), corner[0], 0.});

    const ProfileCurve profile(pieces);
    const double       turn =
      std::min(50. * numbers::PI / 180., 0.75 * (end_angle - start_angle));
    return {profile,
            profile.begin_of(1) + turn * radius,
            profile.begin_of(2),
            profile.begin_of(pieces.size() - 1)};
  }
} // namespace Signorini
