#include <signorini/solid/connected_parts.h>
#include <signorini/solid/rigid_motion.h>

#include <boost/test/unit_test.hpp>

#include "contact_setup.h"

BOOST_AUTO_TEST_SUITE(rigid_motion)

using namespace Signorini;
using namespace dealii;

namespace
{
  std::vector<RigidMode>
  modes(const std::string &supports, const double angle = 0.)
  {
    const SolidModel<2> solid =
      test_model<2>(rectangle("0, 0 ; 2, 1", "4, 2", 1, supports),
                    Formulation::plane_strain);
    // Turned as a whole about the origin.
    Vector<double> displacement(solid.n_dofs());
    for (const auto &node : solid.parts()[0].body->nodes())
      {
        const auto &X = node.point;
        displacement[node.dofs[0]] =
          std::cos(angle) * X[0] - std::sin(angle) * X[1] - X[0];
        displacement[node.dofs[1]] =
          std::sin(angle) * X[0] + std::cos(angle) * X[1] - X[1];
      }
    return solid.free_modes(displacement);
  }

  std::string
  fixed(const std::string &list)
  {
    return "subsection Supports\n set Fixed = " + list + "\nend\n";
  }
} // namespace



BOOST_AUTO_TEST_CASE(what_supports_leave_free)
{
  BOOST_TEST(modes("").size() == 3);
  BOOST_TEST(modes(fixed("bottom: x, y")).empty());
  BOOST_REQUIRE(modes(fixed("left: x")).size() == 1);
  BOOST_TEST(modes(fixed("left: x"))[0].name == "translation along y");
  BOOST_REQUIRE(modes(fixed("bottom: y")).size() == 1);
  BOOST_TEST(modes(fixed("bottom: y"))[0].name == "translation along x");
}



BOOST_AUTO_TEST_CASE(modes_are_rigid_where_the_body_is)
{
  for (const double angle : {0., 0.3, 2.})
    for (const auto &mode : modes("", angle))
      {
        const SolidModel<2> solid =
          test_model<2>(rectangle("0, 0 ; 2, 1", "4, 2"),
                        Formulation::plane_strain);
        // No two nodes come closer: (v_a - v_b).(x_a - x_b) = 0.
        const auto &nodes = solid.parts()[0].body->nodes();
        for (const auto &a : nodes)
          for (const auto &b : nodes)
            {
              const Tensor<1, 2> d = a.point - b.point;
              const Tensor<1, 2> arm(
                {std::cos(angle) * d[0] - std::sin(angle) * d[1],
                 std::sin(angle) * d[0] + std::cos(angle) * d[1]});
              const Tensor<1, 2> v(
                {mode.motion[a.dofs[0]] - mode.motion[b.dofs[0]],
                 mode.motion[a.dofs[1]] - mode.motion[b.dofs[1]]});
              BOOST_TEST(std::abs(v * arm) < 1e-13);
            }
      }
}

BOOST_AUTO_TEST_SUITE_END()
