#include <signorini/geometry/gears/rack_tooth.h>

#include <boost/test/unit_test.hpp>

#include "gear_reference.h"

BOOST_AUTO_TEST_SUITE(gear_teeth)

using dealii::Point;
using GearReference::Gear;
using GearReference::pi;
using GearReference::sample_gears;
using Signorini::GearTooth;
using Signorini::HalfTooth;
using Signorini::ProfileCurve;
using Signorini::RackTooth;

namespace
{
  std::vector<Point<2>>
  points_between(const ProfileCurve &curve,
                 const double        from,
                 const double        to,
                 const unsigned int  n = 50)
  {
    std::vector<Point<2>> points;
    for (unsigned int i = 0; i <= n; ++i)
      points.push_back(curve.at(from + (to - from) * i / n).position);
    return points;
  }
} // namespace



BOOST_AUTO_TEST_CASE(involute)
{
  for (const Gear &gear : sample_gears())
    {
      const GearTooth tooth(gear.n_teeth, gear.tooth);
      const HalfTooth half = tooth.half_tooth();
      const double    m    = gear.tooth.module;

      double nearest = 1e10;
      for (const Point<2> &p :
           points_between(half.profile, half.flank_begin, half.flank_end))
        {
          BOOST_TEST(std::abs(gear.beside_involute(p)) <
                     1e-13 * gear.n_teeth * m);
          nearest = std::min(nearest, std::abs(p.norm() - gear.pitch_radius()));
        }
      // The pitch circle cuts the flank, there with its thickness.
      if (gear.tooth.profile_shift < 1.)
        BOOST_TEST(nearest < 0.05 * m);
      BOOST_TEST(std::abs(2. * gear.half_angle(gear.pitch_radius()) *
                            gear.pitch_radius() -
                          tooth.pitch_thickness()) < 1e-14 * m);

      // Tip and root circle.
      const double shift = gear.tooth.profile_shift;
      BOOST_TEST(std::abs(half.profile.at(half.flank_end).position.norm() -
                          gear.pitch_radius() -
                          (gear.tooth.addendum + shift) * m) <
                 1e-14 * gear.n_teeth * m);
      BOOST_TEST(
        std::abs(half.profile.at(0.).position.norm() - gear.pitch_radius() +
                 (gear.tooth.dedendum - shift) * m) < 1e-14 * gear.n_teeth * m);
    }
}

// Sliding jaws over k teeth touch flanks at the base tangent, W_k = m
// cos(alpha)
// ((k - 0.5) pi + z inv(alpha)) + 2 x m sin(alpha) (ISO 21771), less the
// thinning times cos(alpha).
BOOST_AUTO_TEST_CASE(span_measurement)
{
  const auto span = [](const Gear &gear, const unsigned int k) {
    const HalfTooth half  = GearTooth(gear.n_teeth, gear.tooth).half_tooth();
    const double    angle = (k - 1.) * pi / gear.n_teeth;
    return -2. * GearReference::smallest(
                   [&](const double l) {
                     return -GearReference::turned(half.profile.at(l).position,
                                                   angle)[0];
                   },
                   half.flank_begin,
                   half.flank_end);
  };
  Gear gear{20, {}};
  // Tables for the module 1: 7.6604.
  BOOST_TEST(std::abs(span(gear, 3) - 7.6604) < 5e-5);

  const auto formula = [](const Gear &gear, const unsigned int k) {
    const double alpha = gear.alpha();
    return gear.tooth.module *
             (std::cos(alpha) *
                ((k - 0.5) * pi + gear.n_teeth * GearReference::inv(alpha)) +
              2. * gear.tooth.profile_shift * std::sin(alpha)) -
           gear.tooth.thinning * std::cos(alpha);
  };
  for (const unsigned int k : {2u, 3u})
    for (const double shift : {0., 0.2})
      for (const double thinning : {0., 0.03})
        {
          gear.tooth.profile_shift = shift;
          gear.tooth.thinning      = thinning;
          BOOST_TEST(std::abs(span(gear, k) - formula(gear, k)) < 1e-12);
        }
}

// No point of the fillet lies inside the rounded tip of the cutter at any
// position, and each is touched by it at one.
BOOST_AUTO_TEST_CASE(envelope_of_cutter)
{
  for (const Gear &gear : sample_gears())
    {
      const HalfTooth half = GearTooth(gear.n_teeth, gear.tooth).half_tooth();
      for (const Point<2> &p : points_between(half.profile,
                                              half.profile.begin_of(1),
                                              half.flank_begin))
        {
          BOOST_TEST(std::abs(gear.outside_cutter(p)) <
                     1e-13 * gear.n_teeth * gear.tooth.module);
          for (int i = -100; i <= 100; ++i)
            BOOST_TEST(p.distance(gear.cutter(i * 0.04 * pi / gear.n_teeth)) -
                         gear.tooth.fillet_radius * gear.tooth.module >
                       -1e-13 * gear.n_teeth * gear.tooth.module);
        }
      // Smooth at the root circle and at the involute.
      for (const double l : {half.profile.begin_of(1), half.flank_begin})
        BOOST_TEST((half.profile.at(l).tangent -
                    half.profile.at(l - 1e-12 * half.profile.length()).tangent)
                     .norm() < 1e-10);
    }
}

BOOST_AUTO_TEST_CASE(limits_of_shape)
{
  // A cutter without rounding leaves z >= 2/sin^2 = 17.097 teeth whole.
  Gear gear{17, {}};
  gear.tooth.dedendum      = 1.;
  gear.tooth.fillet_radius = 0.;
  BOOST_TEST(GearTooth(17, gear.tooth).begin_of_involute() < 0.);
  BOOST_TEST(GearTooth(18, gear.tooth).begin_of_involute() > 0.);
  const double sine = std::sin(20. * pi / 180.);
  BOOST_TEST(std::abs(GearTooth(17, gear.tooth).smallest_profile_shift() -
                      (1. - 17. * sine * sine / 2.)) < 1e-14);
  // At the limit the involute begins at the base circle.
  gear.tooth               = {};
  gear.tooth.profile_shift = GearTooth(12, gear.tooth).smallest_profile_shift();
  BOOST_TEST(std::abs(GearTooth(12, gear.tooth).begin_of_involute()) < 1e-14);

  // ISO 53: the basic rack has room for 0.472 modules.
  BOOST_TEST(std::abs(GearTooth(20, {}).largest_fillet_radius() - 0.472) <
             5e-4);
  BOOST_TEST(std::abs(RackTooth({}).largest_fillet_radius() - 0.472) < 5e-4);
  Signorini::ToothParameters round;
  round.fillet_radius = GearTooth(20, {}).largest_fillet_radius();
  BOOST_TEST(std::abs(GearTooth(20, round).half_land_of_cutter()) < 1e-14);
  BOOST_TEST(std::abs(RackTooth(round).half_land_of_root()) < 1e-14);
}

BOOST_AUTO_TEST_CASE(rack)
{
  for (const Gear &gear : sample_gears())
    {
      const RackTooth tooth(gear.tooth);
      const HalfTooth half  = tooth.half_tooth();
      const double    m     = gear.tooth.module;
      const double    alpha = gear.alpha();
      const double    s =
        m * (pi / 2. - 2. * gear.tooth.profile_shift * std::tan(alpha)) -
        gear.tooth.thinning;
      for (const Point<2> &p :
           points_between(half.profile, half.flank_begin, half.flank_end))
        BOOST_TEST(std::abs(p[0] + p[1] * std::tan(alpha) - s / 2.) <
                   1e-14 * m);

      // The fillet is part of a circle that touches root and flank.
      const double   radius = gear.tooth.fillet_radius * m;
      const double   bottom = half.profile.begin_of(1);
      const Point<2> center =
        half.profile.at(bottom).position + Point<2>(0., radius);
      for (const Point<2> &p :
           points_between(half.profile, bottom, half.flank_begin))
        BOOST_TEST(std::abs(p.distance(center) - radius) < 1e-14 * m);
      for (const double l : {bottom, half.flank_begin})
        BOOST_TEST((half.profile.at(l).tangent -
                    half.profile.at(l - 1e-12 * half.profile.length()).tangent)
                     .norm() < 1e-10);
      BOOST_TEST(std::abs(half.profile.at(0.).position[0] - pi * m / 2.) <
                 1e-14 * m);
    }
}

BOOST_AUTO_TEST_CASE(tip_relief)
{
  for (Gear gear : sample_gears())
    {
      const double m           = gear.tooth.module;
      gear.tooth.relief        = 0.004 * m;
      gear.tooth.relief_length = 0.3 * m;
      const GearTooth tooth(gear.n_teeth, gear.tooth);
      const HalfTooth half = tooth.half_tooth();

      // The tip circle stays; a straight line to the base circle, normal to the
      // involute, is the relief shorter than the involute's roll length.
      const Point<2> corner = half.profile.at(half.flank_end).position;
      BOOST_TEST(std::abs(corner.norm() - tooth.tip_radius()) <
                 1e-14 * gear.n_teeth * m);
      const double rb         = gear.base_radius();
      const double height     = std::sqrt(corner.norm_square() - rb * rb);
      const double base_angle = gear.half_angle(rb * (1. + 1e-16)) -
                                std::atan2(corner[0], corner[1]) +
                                std::atan2(height, rb);
      BOOST_TEST(std::abs(rb * base_angle - height - gear.tooth.relief) <
                 1e-12 * gear.n_teeth * m);

      // It begins at its length, and smoothly.
      const double   l     = half.profile.begin_of(3);
      const Point<2> begin = half.profile.at(l).position;
      BOOST_TEST(std::abs(std::sqrt(begin.norm_square() - rb * rb) -
                          tooth.end_of_involute() + gear.tooth.relief_length) <
                 1e-12 * gear.n_teeth * m);
      BOOST_TEST(std::abs(gear.beside_involute(begin)) <
                 1e-13 * gear.n_teeth * m);
      BOOST_TEST((half.profile.at(l).tangent -
                  half.profile.at(l - 1e-12 * half.profile.length()).tangent)
                   .norm() < 1e-10);

      // The rack's is normal to the straight flank.
      const RackTooth rack(gear.tooth);
      const HalfTooth rack_half = rack.half_tooth();
      const Point<2>  tip = rack_half.profile.at(rack_half.flank_end).position;
      BOOST_TEST(std::abs(tip[1] - rack.tip_height()) < 1e-14 * m);
      BOOST_TEST(std::abs((rack.pitch_thickness() / 2. - tip[0]) *
                            std::cos(gear.alpha()) -
                          tip[1] * std::sin(gear.alpha()) - gear.tooth.relief) <
                 1e-14 * m);
    }
}

BOOST_AUTO_TEST_SUITE_END()
