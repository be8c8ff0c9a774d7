#include <signorini/contact/boundary_chain.h>

#include <boost/test/unit_test.hpp>

#include "contact_setup.h"

BOOST_AUTO_TEST_SUITE(boundary_chain)

using namespace Signorini;
using namespace dealii;

namespace
{
  std::vector<BoundaryChain>
  chains(const SolidModel<2> &solid, const std::string &boundary)
  {
    return boundary_chains(*solid.parts()[0].body, boundary, solid.dof_map());
  }

  SolidModel<2>
  ring(const std::string &angles, const unsigned int degree)
  {
    return test_bodies<2>({"set Mesh = ring\nsubsection Ring\n"
                           " set Inner radius = 1\n set Outer radius = 2\n"
                           " set Angles = " +
                           angles +
                           "\n set Cells = 8, 1\nend\nset Element degree = " +
                           std::to_string(degree) + "\n"},
                          Formulation::plane_strain);
  }

  double
  angle_of(const Point<2> &point)
  {
    return std::atan2(point[1], point[0]);
  }
} // namespace



// The body is on the left of who walks along it, whatever the side.
BOOST_AUTO_TEST_CASE(order)
{
  for (const unsigned int degree : {1u, 2u, 3u})
    {
      const auto solid =
        test_bodies<2>({rectangle("0, 0 ; 2, 1", "4, 2", degree)},
                       Formulation::plane_strain);
      const std::vector<
        std::pair<std::string, std::pair<Point<2>, Tensor<1, 2>>>>
        sides = {{"bottom", {Point<2>(0., 0.), Point<2>(1., 0.)}},
                 {"right", {Point<2>(2., 0.), Point<2>(0., 1.)}},
                 {"top", {Point<2>(2., 1.), Point<2>(-1., 0.)}},
                 {"left", {Point<2>(0., 1.), Point<2>(0., -1.)}}};
      for (const auto &[side, line] : sides)
        BOOST_TEST_CONTEXT(side << ", degree " << degree)
        {
          const auto list = chains(solid, side);
          BOOST_REQUIRE(list.size() == 1u);
          const auto &nodes = list[0].nodes;
          BOOST_TEST(!list[0].is_closed);
          BOOST_TEST(nodes.size() ==
                     (line.second[0] != 0. ? 4 : 2) * degree + 1);
          BOOST_TEST(nodes[0].point.distance(line.first) < 1e-14);
          for (unsigned int n = 1; n < nodes.size(); ++n)
            {
              const Tensor<1, 2> step = nodes[n].point - nodes[n - 1].point;
              BOOST_TEST(step * line.second > 0.1 / degree);
              BOOST_TEST(std::abs(step * line.second - step.norm()) < 1e-14);
            }
        }
    }
}



// Counter-clockwise around the body outside, clockwise inside.
BOOST_AUTO_TEST_CASE(closed)
{
  for (const unsigned int degree : {1u, 2u})
    {
      const auto solid = ring("0, 360", degree);
      for (const std::string boundary : {"outer", "inner"})
        BOOST_TEST_CONTEXT(boundary)
        {
          const auto list = chains(solid, boundary);
          BOOST_REQUIRE(list.size() == 1u);
          const auto &nodes = list[0].nodes;
          BOOST_TEST(list[0].is_closed);
          BOOST_TEST(nodes.size() == 8 * degree);
          const double radius = boundary == "outer" ? 2. : 1.;
          const double step   = 2. * numbers::PI / nodes.size();
          for (unsigned int n = 0; n < nodes.size(); ++n)
            {
              BOOST_TEST(std::abs(nodes[n].point.norm() - radius) < 1e-12);
              const double turn =
                angle_of(nodes[(n + 1) % nodes.size()].point) -
                angle_of(nodes[n].point);
              const double expected = boundary == "outer" ? step : -step;
              BOOST_TEST(std::abs(std::remainder(turn - expected,
                                                 2. * numbers::PI)) < 0.02);
            }
          // Curves of elements begin with one of their ends, a vertex of the
          // mesh.
          BOOST_TEST(std::abs(std::remainder(angle_of(nodes[0].point),
                                             numbers::PI / 4.)) < 1e-12);
        }
    }
}



// The next vertices round the corners of an open chain.
BOOST_AUTO_TEST_CASE(open_ends)
{
  for (const unsigned int degree : {1u, 2u})
    {
      const auto solid =
        test_bodies<2>({rectangle("0, 0 ; 2, 1", "4, 2", degree)},
                       Formulation::plane_strain);
      const auto chain = chains(solid, "top")[0];
      BOOST_REQUIRE((chain.ends[0].beyond && chain.ends[1].beyond));
      BOOST_TEST(chain.ends[0].beyond->point.distance(Point<2>(2., 0.5)) <
                 1e-14);
      BOOST_TEST(chain.ends[1].beyond->point.distance(Point<2>(0., 0.5)) <
                 1e-14);
      BOOST_TEST(!chain.ends[0].mirrored_component);
      BOOST_TEST(!chain.ends[1].mirrored_component);
    }
}



// A side that is held across is a line of symmetry; one that is held along
// itself is none, nor is one that is oblique.
BOOST_AUTO_TEST_CASE(symmetric_ends)
{
  const auto with_support = [](const std::string &support,
                               const std::string &boundary,
                               const std::string &more = "") {
    const auto solid =
      test_bodies<2>({rectangle("0, 0 ; 2, 1",
                                "4, 2",
                                1,
                                more + "subsection Supports\n set Fixed = " +
                                  support + "\nend\n")},
                     Formulation::plane_strain);
    return chains(solid, boundary)[0];
  };
  const auto left = with_support("left: x", "top");
  BOOST_TEST(!left.ends[0].mirrored_component);
  BOOST_TEST((left.ends[1].mirrored_component == 0u));
  const auto bottom = with_support("bottom: y", "right");
  BOOST_TEST((bottom.ends[0].mirrored_component == 1u));
  BOOST_TEST(!bottom.ends[1].mirrored_component);
  BOOST_TEST(!with_support("left: y", "top").ends[1].mirrored_component);
  const auto oblique = with_support("left: x",
                                    "top",
                                    "subsection Rectangle\n"
                                    " set Angle = 10\nend\n");
  BOOST_TEST(!oblique.ends[1].mirrored_component);
}

BOOST_AUTO_TEST_SUITE_END()
