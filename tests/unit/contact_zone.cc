#include <signorini/contact/contact_zone.h>

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <limits>

#include "contact_setup.h"

BOOST_AUTO_TEST_SUITE(contact_zone)

using namespace Signorini;

namespace
{
  // The upper one has five nodes at its bottom, 0.5 m apart, and is moved.
  TwoBodies
  two_blocks()
  {
    return TwoBodies(rectangle("0, 1 ; 2, 2", "4, 2"),
                     "bottom",
                     rectangle("-1, 0 ; 3, 1", "4, 1"),
                     "top",
                     {SurfaceInterpolation::Kind::trace},
                     ContactConstraint::node_to_surface,
                     {{0.1, -0.2}});
  }
} // namespace



// The second and the third node are closed.
BOOST_AUTO_TEST_CASE(width_by_the_share_of_closed_nodes)
{
  const TwoBodies     bodies = two_blocks();
  const auto         &pair   = bodies.contact.pairs()[0];
  std::vector<double> forces(bodies.contact.n_contacts(), 0.);
  BOOST_TEST(Signorini::contact_zone(pair, forces, bodies.shift).width == 0.);
  BOOST_TEST(
    Signorini::contact_zone(pair, forces, bodies.shift).points.empty());

  std::vector<dealii::Point<2>> closed;
  for (unsigned int n = 0; n < pair.contactor.nodes.size(); ++n)
    {
      const auto &point = pair.contactor.nodes[n].point;
      if (std::abs(point[0] - 0.75) > 0.3)
        continue;
      forces[pair.first_contact + n] = 7.;
      closed.emplace_back(point[0] + 0.1, point[1] - 0.2);
    }
  BOOST_REQUIRE(closed.size() == 2u);
  const auto zone = Signorini::contact_zone(pair, forces, bodies.shift);
  BOOST_TEST(zone.width == 1., boost::test_tools::tolerance(1e-14));
  BOOST_REQUIRE(zone.points.size() == 2u);
  for (unsigned int n = 0; n < 2; ++n)
    BOOST_TEST(zone.points[n].distance(closed[n]) < 1e-14);
}

// A gap that is a parabola with its lowest point at x = 0.7 m, between the
// nodes at 0.5 and 1 m: it may be closed there, and surely is not when it is
// larger by half a metre.
BOOST_AUTO_TEST_CASE(contact_between_nodes)
{
  const TwoBodies           bodies = two_blocks();
  const auto               &pair   = bodies.contact.pairs()[0];
  const std::vector<double> none(bodies.contact.n_contacts(), 0.);
  for (const double more : {0., 0.5})
    {
      std::vector<double> gaps(none);
      for (unsigned int n = 0; n < pair.contactor.nodes.size(); ++n)
        gaps[n] =
          std::pow(pair.contactor.nodes[n].point[0] - 0.7, 2) - 0.039 + more;
      const auto near = near_misses(pair, none, gaps, bodies.shift);
      BOOST_TEST(near.size() == 5u);
      for (const auto &miss : near)
        BOOST_TEST(miss.may_touch_beside ==
                   (more == 0. && std::abs(miss.point[0] - 0.85) < 0.3));
    }
}

// Closed nodes are none, nor those out of reach.
BOOST_AUTO_TEST_CASE(open_nodes_in_reach)
{
  const TwoBodies     bodies = two_blocks();
  const auto         &pair   = bodies.contact.pairs()[0];
  std::vector<double> forces(bodies.contact.n_contacts(), 0.);
  std::vector<double> gaps(forces.size(), 0.1);
  forces[0]       = 1.;
  gaps[1]         = std::numeric_limits<double>::infinity();
  const auto near = near_misses(pair, forces, gaps, bodies.shift);
  BOOST_TEST(near.size() == 3u);
  for (const auto &miss : near)
    BOOST_TEST(miss.gap == 0.1);
}

BOOST_AUTO_TEST_SUITE_END()
