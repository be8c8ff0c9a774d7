#include <signorini/curves/corner_normals.h>
#include <signorini/curves/curve_weights.h>

#include <boost/test/unit_test.hpp>

BOOST_AUTO_TEST_SUITE(corner_normals)

using namespace Signorini;
using namespace dealii;

namespace
{
  // Two facets, the second half as long; the body is on the left, below: for a
  // positive turn the joint at the origin is convex.
  Curve
  two_facets(const double turn)
  {
    const std::vector<Point<2>> nodes = {Point<2>(1., 0.),
                                         Point<2>(0., 0.),
                                         Point<2>(-0.5 * std::cos(turn),
                                                  -0.5 * std::sin(turn))};
    return CurveWeights::facets(nodes, false).curve(nodes);
  }

  struct Rounded
  {
    CurveProjection projection, original;
    bool            is_changed;
  };

  Rounded
  rounded(const Curve &curve, const Point<2> &x)
  {
    Rounded result;
    result.original   = *CurveSearch(curve).project(x);
    result.projection = result.original;
    result.is_changed = round_joint(curve, result.projection);
    return result;
  }

  // A way at a height above both facets, and round the joint: a length s from
  // there.
  Point<2>
  above(const double turn, const double height, const double s)
  {
    const double arc = turn > 0. ? height * turn : 0.;
    if (s <= 0.)
      return Point<2>(-s, height);
    const double angle = arc > s ? s / height : turn;
    const double along = std::max(0., s - arc);
    return Point<2>(-height * std::sin(angle) - along * std::cos(turn),
                    height * std::cos(angle) - along * std::sin(turn));
  }

  constexpr double zone = 0.05; // parts of a facet
} // namespace



// Along ways across a convex joint at any height, and up from it, normal and
// gap change by no more than in proportion to the step: without rounding the
// normal jumps by the whole turn at the height 0.
BOOST_AUTO_TEST_CASE(no_jump)
{
  for (const double turn : {0.1, 0.4, 0.69})
    {
      const Curve      curve    = two_facets(turn);
      const double     step     = 1e-5;
      constexpr double smallest = zone * 0.5; // of both facets
      // Along the facets the normal turns by half of the turn on each side,
      // round the joint with the arc, whose radius is not smaller than the zone
      // where this is felt.
      const double steepest = (1. + 2. * turn) / smallest;
      const auto   walk     = [&](const auto &way) {
        double largest_turn = 0.;
        auto   last         = rounded(curve, way(-0.1)).projection;
        for (double s = -0.1 + step; s < 0.1; s += step)
          {
            const auto next = rounded(curve, way(s)).projection;
            largest_turn =
              std::max(largest_turn, (next.normal - last.normal).norm());
            BOOST_TEST(std::abs(next.gap - last.gap) < 1.1 * step);
            last = next;
          }
        return largest_turn;
      };
      for (const double height : {0., 1e-12, 0.003, 0.012, 0.024, 0.026, 0.06})
        BOOST_TEST_CONTEXT("turn " << turn << ", height " << height)
        {
          const double largest =
            walk([&](const double s) { return above(turn, height, s); });
          BOOST_TEST(largest < steepest * step);
        }
      for (const double share : {0.2, 0.5, 1.})
        BOOST_TEST(walk([&](const double s) {
                     return Point<2>((s + 0.1) * above(turn, 1., share * turn));
                   }) < steepest * step);
    }
}



// What is touching stays so, the gap errs by 1 - cos(turn/2) of itself, the
// normal by half the turn; and nothing is changed off the joint, at a corner,
// or where both facets have one direction.
BOOST_AUTO_TEST_CASE(bounded_errors)
{
  for (const double turn : {-0.69, -0.3, 0.1, 0.4, 0.69})
    {
      const Curve curve = two_facets(turn);
      for (const double height : {-0.02, -1e-3, 0., 1e-3, 0.02, 0.04})
        for (double s = -0.1; s < 0.1; s += 1.37e-3)
          BOOST_TEST_CONTEXT("turn " << turn << ", height " << height << " at "
                                     << s)
          {
            const auto [projection, original, is_changed] =
              rounded(curve, above(turn, height, s));
            BOOST_TEST(angle_between(projection.normal, original.normal) <=
                       0.5 * std::abs(turn) + 1e-12);
            BOOST_TEST(std::abs(projection.gap) <= std::abs(original.gap));
            BOOST_TEST(std::abs(projection.gap) >=
                       std::cos(0.5 * turn) * std::abs(original.gap) - 1e-15);
            const double part =
              original.segment == 0 ? 1. - original.xi : original.xi;
            BOOST_TEST(is_changed ==
                       (part < zone && std::abs(original.gap) < 0.5 * zone));
          }
    }
  for (const double turn : {0., 1e-7, 0.71, 1.5})
    BOOST_TEST(!rounded(two_facets(turn), Point<2>(0.01, 0.)).is_changed);
}

BOOST_AUTO_TEST_SUITE_END()
