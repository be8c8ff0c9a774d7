#include <signorini/dynamics/free_modes.h>

#include <boost/test/unit_test.hpp>

BOOST_AUTO_TEST_SUITE(free_modes)

using namespace Signorini;
using namespace dealii;

namespace
{
  // Three nodes on a line, which move along y: translation and rotation.
  const std::vector<Vector<double>> two_modes = {Vector<double>{1., 1., 1.},
                                                 Vector<double>{-1., 0., 1.}};

  double
  stiffness(const std::vector<FreeModes::Spring> &springs,
            const Vector<double>                 &motion)
  {
    double sum = 0.;
    for (const auto &[row, spring] : springs)
      sum += spring * row.dot(motion) * row.dot(motion);
    return sum;
  }
} // namespace



BOOST_AUTO_TEST_CASE(pins_hold_all_modes)
{
  const auto pins = FreeModes::pins(two_modes, DofMap(3, 0));
  BOOST_REQUIRE(pins.size() == 2);
  const double determinant = two_modes[0][pins[0]] * two_modes[1][pins[1]] -
                             two_modes[0][pins[1]] * two_modes[1][pins[0]];
  BOOST_TEST(std::abs(determinant) >= 1.);
  // Not where an unknown is constrained.
  DofMap dof_map(3, 0);
  dof_map.prescribe(1);
  for (const unsigned int pin : FreeModes::pins(two_modes, dof_map))
    BOOST_TEST(pin != 1);
}



BOOST_AUTO_TEST_CASE(springs_against_what_nothing_holds)
{
  const FreeModes modes(two_modes, {2e6, 2e6});
  const auto      springs = modes.springs({});
  BOOST_TEST(springs.size() == 2);
  for (const auto &mode : two_modes)
    BOOST_TEST(stiffness(springs, mode) == 2.,
               boost::test_tools::tolerance(1e-12)); // 1e-6 of 2e6
}



BOOST_AUTO_TEST_CASE(what_contacts_hold_needs_no_springs)
{
  const FreeModes modes(two_modes, {2e6, 2e6});
  // 1. The first node held: what is left turns about it.
  const std::vector<FreeModes::Spring> one  = {{{{0, 1.}}, 1e6}};
  const auto                           rest = modes.springs(one);
  BOOST_REQUIRE(rest.size() == 1);
  Vector<double> about_the_first{0., 1., 2.};
  Vector<double> all(about_the_first);
  BOOST_TEST(stiffness(rest, about_the_first) > 0.5);
  // 2. Two nodes held, however softly.
  BOOST_TEST(modes.springs({{{{0, 1.}}, 1e-2}, {{{2, 1.}}, 1e-2}}).empty());
  // 3. So softly that it would drown in rounding.
  BOOST_TEST(modes.springs({{{{0, 1.}}, 1e-6}, {{{2, 1.}}, 1e-6}}).size() == 2);
}



BOOST_AUTO_TEST_CASE(nothing_is_free)
{
  BOOST_TEST(FreeModes().springs({}).empty());
  BOOST_TEST(FreeModes().empty());
}

BOOST_AUTO_TEST_SUITE_END()
