#include <signorini/geometry/gears/rack_tooth.h>
#include <signorini/geometry/gears/tooth_row.h>

#include <boost/test/unit_test.hpp>

#include "gear_reference.h"

BOOST_AUTO_TEST_SUITE(profile_curve)

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
  // The curve has no gaps, its parameter is the arc length, its tangents are
  // those of the curve, and points on it are found again.
  void
  check_curve(const ProfileCurve &curve, const double tolerance)
  {
    const double       length = curve.length(), h = 1e-5 * length;
    const unsigned int n = 400;
    for (unsigned int i = 0; i < n; ++i)
      {
        const double l  = length * (i + 0.5) / n;
        const auto   at = curve.at(l);
        BOOST_TEST(std::abs(at.tangent.norm() - 1.) < 1e-14);
        BOOST_TEST(std::abs(curve.closest(at.position) - l) < 1e-12 * length);
        bool near_corner = false;
        for (unsigned int p = 0; p < curve.get_pieces().size(); ++p)
          near_corner |= std::abs(curve.begin_of(p) - l) < 2. * h;
        if (!near_corner)
          BOOST_TEST(
            ((curve.at(l + h).position - curve.at(l - h).position) / (2. * h) -
             at.tangent)
              .norm() < tolerance);
      }
    for (unsigned int p = 1; p < curve.get_pieces().size(); ++p)
      {
        const double l = curve.begin_of(p);
        BOOST_TEST(curve.at(l).position.distance(
                     curve.at(l - 1e-13 * length).position) < 1e-12 * length);
      }
  }
} // namespace



BOOST_AUTO_TEST_CASE(curves)
{
  for (Gear gear : sample_gears())
    {
      check_curve(GearTooth(gear.n_teeth, gear.tooth).half_tooth().profile,
                  1e-6);
      check_curve(RackTooth(gear.tooth).half_tooth().profile, 1e-6);
      // The reliefs' parameter is the arc length up to their slope.
      gear.tooth.relief        = 0.005 * gear.tooth.module;
      gear.tooth.relief_length = 0.3 * gear.tooth.module;
      check_curve(GearTooth(gear.n_teeth, gear.tooth).half_tooth().profile,
                  0.01);
      check_curve(RackTooth(gear.tooth).half_tooth().profile, 0.02);
    }
}

// Points of a profile of all teeth are found again, and their mean is taken the
// short way around a closed gear.
BOOST_AUTO_TEST_CASE(profile_of_a_row)
{
  const HalfTooth half   = GearTooth(20, {}).half_tooth();
  const double    length = 2. * half.profile.length();
  for (const unsigned int n : {1u, 3u, 20u})
    {
      const Signorini::ToothRow row = {
        true, Point<2>(3., 4.), 2., 2. * pi / 20., n};
      const Signorini::RowProfile profile(row, half.profile);
      BOOST_TEST(row.is_closed() == (n == 20));
      for (unsigned int i = 0; i < 100 * n; ++i)
        {
          const double l = ((i + 0.5) / 100. - 0.5) * length;
          BOOST_TEST(std::abs(profile.closest(profile.at(l)) - l) <
                     1e-11 * length);
          BOOST_TEST((profile.at(l + 1e-6) - profile.at(l - 1e-6) -
                      2e-6 * profile.tangent_at(l))
                       .norm() < 1e-6 * 2e-6 + 4e-6 * (i % 100 % 25 == 0));
        }
      if (n == 20)
        for (const double l : {-0.6, -0.5, -0.4, 0.3})
          BOOST_TEST(
            profile.at(l * length).distance(profile.at((l + 20.) * length)) <
            1e-12);
      BOOST_TEST(std::abs(profile.way(0., (n - 0.1) * length) -
                          (n == 20 ? -0.1 : n - 0.1) * length) <
                 1e-12 * length);
    }
}

BOOST_AUTO_TEST_SUITE_END()
