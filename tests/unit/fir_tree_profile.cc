#include <signorini/geometry/fir_tree/fir_tree_profile.h>

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

#include "fir_tree_sets.h"

BOOST_AUTO_TEST_SUITE(fir_tree_profile)

using dealii::Point;
using dealii::Tensor;
using Signorini::blade_profile;
using Signorini::FirTreeJoint;
using Signorini::ProfilePiece;
using Signorini::slot_profile;
using Kind = ProfilePiece::Kind;

namespace
{
  const double pi = 3.14159265358979323846;

  // Angle of a direction from the x axis, degrees.
  double
  direction(const Tensor<1, 2> &t)
  {
    return std::atan2(t[1], t[0]) * 180. / pi;
  }

  // Distance of a point from a piece.
  double
  distance(const Point<2> &p, const ProfilePiece &piece)
  {
    double nearest   = std::min(p.distance(piece.start), p.distance(piece.end));
    const auto along = piece.end - piece.start;
    if (!piece.is_arc())
      {
        const double s = (p - piece.start) * along / along.norm_square();
        return s > 0. && s < 1. ? p.distance(piece.start + s * along) : nearest;
      }
    // In the sector of the arc if it is on the inner side of both end rays.
    const auto   arm  = p - piece.center;
    const double sign = piece.turn > 0. ? 1. : -1.;
    const auto   side = [&](const Point<2> &end) {
      const auto ray = end - piece.center;
      return sign * (ray[0] * arm[1] - ray[1] * arm[0]);
    };
    if (side(piece.start) >= 0. && side(piece.end) <= 0.)
      nearest = std::abs(arm.norm() - piece.radius());
    return nearest;
  }

  double
  distance(const Point<2> &p, const std::vector<ProfilePiece> &profile)
  {
    double nearest = 1.;
    for (const ProfilePiece &piece : profile)
      nearest = std::min(nearest, distance(p, piece));
    return nearest;
  }

  // Pieces follow each other without steps and without corners.
  void
  check_chain(const std::vector<ProfilePiece> &profile)
  {
    BOOST_TEST(profile.back().end[0] == 0.);
    for (unsigned int i = 0; i < profile.size(); ++i)
      {
        const ProfilePiece &piece = profile[i];
        BOOST_TEST(piece.start.distance(piece.end) > 0.);
        BOOST_TEST(std::abs(piece.tangent(0.).norm() - 1.) < 1e-12);
        if (piece.is_arc())
          {
            BOOST_TEST(std::abs(piece.end.distance(piece.center) -
                                piece.radius()) < 1e-14);
            // The turn is the one from start to end.
            BOOST_TEST(piece.end.distance(piece.part(0., 1. - 1e-12).end) <
                       1e-12);
          }
        if (i + 1 < profile.size())
          {
            BOOST_TEST(piece.end.distance(profile[i + 1].start) == 0.);
            BOOST_TEST((piece.tangent(1.) - profile[i + 1].tangent(0.)).norm() <
                       1e-12);
          }
      }
    // At the y axis it is horizontal: no corner between the halves.
    BOOST_TEST(std::abs(profile.back().tangent(1.)[1]) < 1e-12);
  }

  void
  check_measures(const FirTreeJoint &joint, const double shank_height)
  {
    const std::vector<ProfilePiece> profile =
      blade_profile(joint, shank_height);
    BOOST_TEST(profile.size() == 4 * joint.n_teeth + 2);
    BOOST_TEST(std::abs(profile[0].start.distance(profile[0].end) -
                        shank_height) < 1e-14);
    std::vector<double>   necks;
    std::vector<Point<2>> flanks;
    for (const ProfilePiece &piece : profile)
      {
        const Tensor<1, 2> along = piece.tangent(0.);
        if (piece.kind == Kind::contact)
          {
            BOOST_TEST(std::abs(piece.start.distance(piece.end) -
                                joint.flank_length) < 1e-14);
            BOOST_TEST(std::abs(direction(along) + joint.contact_angle) <
                       1e-10);
            flanks.push_back(piece.start);
          }
        if (piece.kind == Kind::back)
          {
            BOOST_TEST(std::abs(direction(-along) - joint.back_angle) < 1e-10);
            if (piece.tooth < joint.n_teeth)
              BOOST_TEST(std::abs(piece.start.distance(piece.end) -
                                  joint.back_flank_length()) < 1e-14);
          }
        if (piece.kind == Kind::fillet)
          {
            BOOST_TEST(std::abs(piece.radius() - joint.root_radius) < 1e-14);
            necks.push_back(piece.center[0] - piece.radius());
          }
        if (piece.kind == Kind::tip)
          BOOST_TEST(std::abs(piece.radius() - joint.tip_radius) < 1e-14);
        if (piece.kind == Kind::bottom)
          BOOST_TEST(std::abs(piece.radius() - joint.bottom_radius) < 1e-14);
      }
    BOOST_TEST(std::abs(2. * necks.back() - joint.bottom_neck_width) < 1e-14);
    BOOST_TEST(std::abs(profile[0].end[0] - necks.front()) < 1e-14);

    // Each tooth is the one above it, moved down the taper by one pitch.
    for (unsigned int i = 1; i < flanks.size(); ++i)
      {
        const Tensor<1, 2> step = flanks[i] - flanks[i - 1];
        BOOST_TEST(std::abs(step.norm() - joint.pitch()) < 1e-13);
        BOOST_TEST(std::abs(direction(step) + 90. + joint.taper_angle) < 1e-9);
      }
  }

  void
  check_gap(const FirTreeJoint &joint)
  {
    const auto blade = blade_profile(joint, joint.mouth_depth);
    const auto slot  = slot_profile(joint);
    // Next to the disc's tips the blade's fillets begin a bit earlier: seen
    // from the end of a tip of radius R there, the arc of radius r is at the
    // distance r - sqrt(r^2 - 2 R c) > (R/r) c.
    double least = 1.;
    for (const ProfilePiece &piece : slot)
      if (piece.kind == Kind::fillet)
        least = std::min(least, piece.radius() / joint.root_radius);
    least *= joint.clearance;
    BOOST_TEST(slot.size() == blade.size());
    BOOST_TEST(std::abs(slot[0].start.norm() - joint.rim_radius) < 1e-14);
    for (unsigned int i = 0; i < slot.size(); ++i)
      {
        BOOST_TEST((slot[i].kind == blade[i].kind));
        double last = 0.;
        for (unsigned int j = 0; j <= 20; ++j)
          {
            // Along arcs the gap grows away from the working flank.
            const bool   backwards = slot[i].kind == Kind::fillet;
            const double s         = backwards ? 1. - j / 20. : j / 20.;
            const double gap       = distance(slot[i].at(s), blade);
            switch (slot[i].kind)
              {
                case Kind::contact:
                  BOOST_TEST(gap < 1e-15);
                  break;
                case Kind::fillet:
                case Kind::tip:
                  BOOST_TEST(gap > last - 1e-14);
                  last = gap;
                  break;
                default:
                  BOOST_TEST(gap > least - 1e-14);
                  BOOST_TEST(gap < joint.clearance + 1e-14);
              }
          }
        if (slot[i].kind == Kind::fillet || slot[i].kind == Kind::tip)
          BOOST_TEST(last > least - 1e-14);
        if (slot[i].kind == Kind::contact)
          {
            BOOST_TEST(slot[i].start.distance(blade[i].start) < 1e-15);
            BOOST_TEST(slot[i].end.distance(blade[i].end) < 1e-15);
          }
      }
  }
} // namespace



BOOST_AUTO_TEST_CASE(default_joint)
{
  const FirTreeJoint joint = joint_from("");
  // alpha + beta = 60, cos 60 = 1/2: p = (0.003 sin 60 + 0.003)/cos 47.
  const double cosine = std::cos(47. * pi / 180.);
  BOOST_TEST(std::abs(joint.pitch() - 0.003 * (std::sqrt(0.75) + 1.) / cosine) <
             1e-15);
  BOOST_TEST(joint.tip_turn() == 120.);
  check_measures(joint, 0.01);
  check_chain(blade_profile(joint, 0.01));
  check_chain(slot_profile(joint));
  check_gap(joint);
}

// The clearance itself, where nothing is between: in the middle of a flank.
BOOST_AUTO_TEST_CASE(clearance)
{
  const FirTreeJoint joint = joint_from("");
  const auto         blade = blade_profile(joint, 0.003);
  for (const ProfilePiece &piece : slot_profile(joint))
    if (piece.kind == Kind::side || piece.kind == Kind::back ||
        piece.kind == Kind::bottom)
      BOOST_TEST(std::abs(distance(piece.at(0.5), blade) - 1e-4) < 1e-15);
}

BOOST_AUTO_TEST_CASE(random_joints)
{
  for (const std::string &lines : random_joint_lines(50, 1))
    BOOST_TEST_CONTEXT(lines)
    {
      const FirTreeJoint joint = joint_from(lines);
      check_measures(joint, 0.01);
      check_chain(blade_profile(joint, 0.01));
      check_chain(slot_profile(joint));
      check_gap(joint);
    }
}

BOOST_AUTO_TEST_CASE(arcs)
{
  // A quarter of the circle about (1, 2), to the left from (3, 2) up.
  const ProfilePiece piece = {
    Kind::tip, 1, Point<2>(3., 2.), Point<2>(1., 4.), Point<2>(1., 2.), 90.};
  BOOST_TEST(piece.radius() == 2.);
  const double half = std::sqrt(2.);
  BOOST_TEST(piece.at(0.5).distance(Point<2>(1. + half, 2. + half)) < 1e-15);
  BOOST_TEST((piece.tangent(0.) - Tensor<1, 2>({0., 1.})).norm() < 1e-15);
  BOOST_TEST((piece.tangent(1.) - Tensor<1, 2>({-1., 0.})).norm() < 1e-15);
  const ProfilePiece part = piece.part(0.5, 1.);
  BOOST_TEST(part.turn == 45.);
  BOOST_TEST(part.end.distance(piece.end) == 0.);
}

BOOST_AUTO_TEST_CASE(neck_of_the_disc)
{
  // The slots touch the radial plane when the neck is zero.
  const FirTreeJoint joint = joint_from("");
  const double       angle = pi / joint.n_blades;
  double             neck  = 1.;
  for (const ProfilePiece &piece : slot_profile(joint))
    for (unsigned int j = 0; j <= 1000; ++j)
      {
        const Point<2> p = piece.at(j / 1000.);
        neck = std::min(neck, p[1] * std::sin(angle) - p[0] * std::cos(angle));
      }
  BOOST_TEST(std::abs(disc_neck(joint) - neck) < 1e-8);
}

BOOST_AUTO_TEST_SUITE_END()
