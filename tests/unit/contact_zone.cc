#include <signorini/contact/contact_zone.h>

#include <boost/test/unit_test.hpp>

#include "contact_setup.h"

using namespace Signorini;

BOOST_AUTO_TEST_SUITE(contact_zone)

// Four pieces of 0.5 m, five nodes; the second and the third are closed.
BOOST_AUTO_TEST_CASE(width_by_the_share_of_closed_nodes)
{
  const TwoBodies     bodies(rectangle("0, 1 ; 2, 2", "4, 2"),
                         "bottom",
                         rectangle("-1, 0 ; 3, 1", "4, 1"),
                         "top",
                         {SurfaceInterpolation::Kind::trace},
                         ContactConstraint::node_to_surface,
                         {{0.1, -0.2}});
  const auto         &pair = bodies.contact.pairs()[0];
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

BOOST_AUTO_TEST_SUITE_END()
