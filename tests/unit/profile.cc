#include <signorini/contact/profile.h>
#include <signorini/curves/outline.h>
#include <signorini/input/input_error.h>

#include <deal.II/base/parameter_handler.h>

#include <boost/test/unit_test.hpp>

#include <fstream>

#include "contains.h"
#include "random_curves.h"

BOOST_AUTO_TEST_SUITE(profile)

using namespace Signorini;
using namespace dealii;

namespace
{
  std::unique_ptr<RigidSurface<2>>
  create(const std::string &entries, const std::string &directory = "")
  {
    ParameterHandler prm;
    declare_rigid_surface_parameters<2>(prm);
    prm.parse_input_from_string("set Shape = profile\nsubsection Profile\n" +
                                entries + "\nend\n");
    return create_rigid_surface<2>(prm, "Rigid body tool", directory);
  }

  std::string
  refusal(const std::string &entries)
  {
    try
      {
        create(entries);
      }
    catch (const InputError &error)
      {
        return error.what();
      }
    return "nothing";
  }

  const std::string slot = "set Outline = 0, 0 ; 1, 0 ; arc 1.5, 0.5 to 1, 1 ;"
                           " 0, 1 ; left about 0, 0.5 to 0, 0\n"
                           "set Closed = true";
} // namespace



// A whole circle from arcs is the analytic one, with its curvature.
BOOST_AUTO_TEST_CASE(circle_of_arcs)
{
  RandomCurves  random(51);
  const Profile arcs(circle(Point<2>(1., 2.), 0.5));
  for (unsigned int trial = 0; trial < 200; ++trial)
    {
      const Point<2>     x        = random.point(-2., 4.);
      const Tensor<1, 2> arm      = x - Point<2>(1., 2.);
      const double       distance = arm.norm();
      if (distance < 0.05)
        continue;
      const auto found = arcs.closest(x);
      BOOST_TEST(std::abs(found.gap - (distance - 0.5)) < 1e-10);
      BOOST_TEST((found.normal - arm / distance).norm() < 1e-8);
      const Tensor<2, 2> expected =
        (unit_symmetric_tensor<2>() -
         symmetrize(outer_product(found.normal, found.normal))) /
        distance;
      BOOST_TEST((Tensor<2, 2>(found.curvature) - expected).norm() <
                 1e-4 * expected.norm());
    }
}



// Gap and normal are consistent: finite differences of the gap are the normal,
// those of the normal the curvature.
BOOST_AUTO_TEST_CASE(derivatives)
{
  RandomCurves random(52);
  const auto   tool =
    create("set Points = 2, 0 ; 1, 0.4 ; 0, 0 ; -1, -0.4 ; -2, 0");
  for (unsigned int trial = 0; trial < 100; ++trial)
    {
      const Point<2> x(random.number(-1.8, 1.8), random.number(-0.5, 1.));
      const auto     here = tool->closest(x);
      const double   step = 1e-6;
      for (unsigned int d = 0; d < 2; ++d)
        {
          Point<2> low = x, high = x;
          low[d] -= step;
          high[d] += step;
          const auto before = tool->closest(low), after = tool->closest(high);
          if ((after.normal - before.normal).norm() > 0.01)
            continue; // from one branch of the curve to another
          BOOST_TEST(std::abs((after.gap - before.gap) / (2. * step) -
                              here.normal[d]) < 1e-6);
          const double size = 1. + here.curvature.norm();
          for (unsigned int c = 0; c < 2; ++c)
            BOOST_TEST(
              std::abs((after.normal[c] - before.normal[c]) / (2. * step) -
                       here.curvature[c][d]) < 1e-4 * size * size);
        }
    }
}



BOOST_AUTO_TEST_CASE(outline)
{
  const auto tool = create(slot);
  BOOST_TEST(!tool->is_flat());
  const auto above = tool->closest(Point<2>(0.5, 1.25));
  BOOST_TEST(std::abs(above.gap - 0.25) < 1e-15);
  BOOST_TEST(std::abs(above.normal[1] - 1.) < 1e-15);
  BOOST_TEST(above.curvature.norm() < 1e-12);
  BOOST_TEST(std::abs(tool->closest(Point<2>(2., 0.5)).gap - 0.5) < 1e-10);
  BOOST_TEST(std::abs(tool->closest(Point<2>(-0.75, 0.5)).gap - 0.25) < 1e-10);
  BOOST_TEST(std::abs(tool->closest(Point<2>(0.5, 0.1)).gap + 0.1) < 1e-15);
  const auto hole = create(slot + "\nset Solid side = around");
  BOOST_TEST(std::abs(hole->closest(Point<2>(0.5, 0.1)).gap - 0.1) < 1e-15);
  // The direction of the walk does not count then.
  const std::string clockwise = "set Points = 0, 0 ; 0, 1 ; 1, 1 ; 1, 0\n"
                                "set Closed = true\nset Curve = segments\n";
  BOOST_TEST(contains(refusal(clockwise), "runs clockwise"));
  BOOST_TEST(create(clockwise + "set Solid side = within")
               ->closest(Point<2>(0.5, 1.5))
               .gap == 0.5);
  BOOST_TEST(create(clockwise + "set Solid side = around")
               ->closest(Point<2>(0.5, 1.5))
               .gap == -0.5);
  // Open, with the body on the right.
  const std::string line = "set Points = 0, 0 ; 1, 0\nset Curve = segments\n";
  BOOST_TEST(create(line)->closest(Point<2>(0.5, 0.25)).gap == -0.25);
  const auto floor = create(line + "set Solid side = right");
  BOOST_TEST(floor->closest(Point<2>(0.5, 0.25)).gap == 0.25);
  // Beyond its end the distance from it.
  BOOST_TEST(std::abs(floor->closest(Point<2>(1.3, 0.4)).gap - 0.5) < 1e-15);
  BOOST_TEST(std::abs(floor->closest(Point<2>(1.3, -0.4)).gap - 0.5) < 1e-15);
}



BOOST_AUTO_TEST_CASE(file)
{
  const std::string path = "unit_test_profile.txt";
  {
    std::ofstream out(path);
    out << "# x y\n1, 0\n\n0.5\t0 # in the middle\n0 0\n";
  }
  BOOST_TEST(
    std::abs(
      create("set File = " + path, ".")->closest(Point<2>(0.25, 0.5)).gap -
      0.5) < 1e-15);
  {
    std::ofstream out(path);
    out << "1 0\n0 0 0\n";
  }
  BOOST_TEST(contains(refusal("set File = " + path), path + ":2: two numbers"));
  std::remove(path.c_str());
  BOOST_TEST(contains(refusal("set File = " + path), "cannot be read"));
}



BOOST_AUTO_TEST_CASE(refused)
{
  BOOST_TEST(contains(refusal(""), "found none of them"));
  BOOST_TEST(contains(refusal("set Points = 0, 0"), "at least 2 points"));
  BOOST_TEST(
    contains(refusal("set Points = 0, 0 ; 1, 0 ; 1, 0"), "points 2 and 3"));
  BOOST_TEST(contains(refusal("set Points = 0, 0 ; 1"), "2 coordinates"));
  BOOST_TEST(contains(refusal("set Points = 0, 0 ; 1, 0\nset File = a.txt"),
                      "found 2."));
  BOOST_TEST(contains(refusal("set Points = 0, 0 ; 1, 0\n"
                              "set Solid side = within"),
                      "the curve is open"));
  BOOST_TEST(contains(refusal("set Outline = 0, 0 ; arc 1, 0 to 2, 0"),
                      "must not lie on one line"));
  BOOST_TEST(contains(refusal("set Outline = 0, 0 ; arc 1, 0"), "where it "));
  BOOST_TEST(contains(refusal("set Outline = 0, 0 ; left about 1, 0 to 3, 0"),
                      "both must be the radius"));
}

BOOST_AUTO_TEST_SUITE_END()
