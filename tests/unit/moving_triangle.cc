#include <signorini/curves/moving_triangle.h>

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <random>

BOOST_AUTO_TEST_SUITE(moving_triangle)

using namespace Signorini;
using namespace dealii;

namespace
{
  // In the plane z = 0, its normal along z.
  const std::array<Point<3>, 3> flat = {
    {Point<3>(0., 0., 0.), Point<3>(1., 0., 0.), Point<3>(0., 1., 0.)}};

  std::array<Point<3>, 3>
  moved(const std::array<Point<3>, 3> &corners,
        const Tensor<2, 3>            &turn,
        const Tensor<1, 3>            &shift)
  {
    std::array<Point<3>, 3> result;
    for (unsigned int a = 0; a < 3; ++a)
      result[a] = Point<3>(turn * corners[a] + shift);
    return result;
  }

  Tensor<2, 3>
  turn_about_x(const double angle)
  {
    Tensor<2, 3> turn;
    turn[0][0] = 1.;
    turn[1][1] = turn[2][2] = std::cos(angle);
    turn[2][1]              = std::sin(angle);
    turn[1][2]              = -std::sin(angle);
    return turn;
  }
} // namespace



BOOST_AUTO_TEST_CASE(a_triangle_at_rest)
{
  const MovingTriangle at_rest = {flat, flat};
  const auto           goes = [&](const Point<3> &start, const Point<3> &end) {
    return passes(start, end, at_rest, 1e-9);
  };
  BOOST_TEST(goes({0.2, 0.3, 0.1}, {0.2, 0.3, -0.1}));
  // From behind, beside it, not far enough, and along it.
  BOOST_TEST(!goes({0.2, 0.3, -0.1}, {0.2, 0.3, 0.1}));
  BOOST_TEST(!goes({0.7, 0.7, 0.1}, {0.7, 0.7, -0.1}));
  BOOST_TEST(!goes({0.2, 0.3, 0.1}, {0.2, 0.3, 0.}));
  BOOST_TEST(!goes({0.2, 0.3, 0.}, {0.3, 0.3, 0.}));
  // No deeper than the tolerance.
  BOOST_TEST(!goes({0.2, 0.3, 0.1}, {0.2, 0.3, -1e-10}));
  BOOST_TEST(goes({0.2, 0.3, 0.1}, {0.2, 0.3, -1e-8}));
}



BOOST_AUTO_TEST_CASE(what_turns_together_stays_on_its_side)
{
  // Straight ways of all points are an affine map at every instant.
  std::mt19937                           generator(1);
  std::uniform_real_distribution<double> random(-1., 1.);
  for (unsigned int trial = 0; trial < 200; ++trial)
    {
      const auto           turn = turn_about_x(0.5 * random(generator));
      const Tensor<1, 3>   shift({random(generator), random(generator), 1.});
      const MovingTriangle triangle = {flat, moved(flat, turn, shift)};
      const Point<3>       above(0.5 + 0.5 * random(generator),
                           0.5 + 0.5 * random(generator),
                           1e-6);
      BOOST_TEST(
        !passes(above, Point<3>(turn * above + shift), triangle, 1e-9));
    }
}



BOOST_AUTO_TEST_CASE(a_triangle_that_turns_over_a_point)
{
  // It turns from horizontal to 60 degrees about its edge on the x axis, over a
  // point that rests above it; turned the other way, it leaves the point alone.
  const double         angle = M_PI / 3.;
  const MovingTriangle up    = {flat, moved(flat, turn_about_x(angle), {})};
  const MovingTriangle down  = {flat, moved(flat, turn_about_x(-angle), {})};
  const Point<3>       point(0.3, 0.3, 0.1);
  BOOST_TEST(passes(point, point, up, 1e-9));
  BOOST_TEST(!passes(point, point, down, 1e-9));
}



BOOST_AUTO_TEST_CASE(in_and_out_again)
{
  // The triangle goes up and down beyond the point within half of the way only
  // if the point moves, too: here both move along z, the triangle faster.
  const MovingTriangle rises = {
    flat, moved(flat, turn_about_x(0.), Tensor<1, 3>({0., 0., 1.}))};
  BOOST_TEST(passes({0.2, 0.2, 0.5}, {0.2, 0.2, 0.6}, rises, 1e-9));
  BOOST_TEST(!passes({0.2, 0.2, 0.5}, {0.2, 0.2, 1.6}, rises, 1e-9));
}

BOOST_AUTO_TEST_SUITE_END()
