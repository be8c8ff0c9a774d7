#include <signorini/curves/curve_crossing.h>
#include <signorini/curves/curve_search.h>
#include <signorini/curves/outline.h>

#include <boost/test/unit_test.hpp>

#include "random_curves.h"

BOOST_AUTO_TEST_SUITE(curve_crossing)

using namespace Signorini;
using namespace dealii;

namespace
{
  Curve
  ring(const std::vector<Point<2>> &nodes)
  {
    return CurveWeights::overhauser(nodes,
                                    true,
                                    CurveWeights::Knots::centripetal,
                                    180.)
      .curve(nodes);
  }

  // The curve between two states.
  Curve
  between(const Curve &start, const Curve &end, const double t)
  {
    Curve result = start;
    for (unsigned int s = 0; s < start.n_segments(); ++s)
      {
        BezierSegment segment = start.segment(s);
        for (unsigned int i = 0; i < 4; ++i)
          segment.control[i] +=
            t * (end.segment(s).control[i] - start.segment(s).control[i]);
        result.set_segment(s, segment);
      }
    return result;
  }

  // The first of many instants at which the sign of the gap has become
  // negative.
  double
  sampled_crossing(const Curve       &start,
                   const Curve       &end,
                   const Point<2>    &x,
                   const Point<2>    &X,
                   const unsigned int n)
  {
    double last = -1.;
    for (unsigned int i = 0; i <= n; ++i)
      {
        const double t     = i / double(n);
        const Curve  curve = between(start, end, t);
        const double gap   = CurveSearch(curve).project(x + t * (X - x))->gap;
        if (gap < 0. && last > 0.)
          return t;
        last = gap;
      }
    return 2.;
  }
} // namespace



// A thin plate that is passed within one step, and one that is missed.
BOOST_AUTO_TEST_CASE(tunnelling)
{
  const std::vector<Point<2>> nodes = {Point<2>(0., 0.),
                                       Point<2>(4., 0.),
                                       Point<2>(4., 0.1),
                                       Point<2>(0., 0.1)};
  const Curve         curve = CurveWeights::facets(nodes, true).curve(nodes);
  const CurveCrossing crossing(curve);
  const auto down = crossing.first(Point<2>(1., 1.1), Point<2>(2., -0.9));
  BOOST_TEST(down.has_value());
  BOOST_TEST(std::abs(down->fraction - 0.5) < 1e-12);
  BOOST_TEST(down->place.segment == 2u);
  BOOST_TEST(std::abs(curve.value(down->place)[0] - 1.5) < 1e-12);
  BOOST_TEST(!crossing.first(Point<2>(5., 1.), Point<2>(5., -1.)).has_value());
  BOOST_TEST(!crossing.first(Point<2>(1., 1.), Point<2>(1., 0.2)).has_value());
  // From within to without is no contact.
  BOOST_TEST(!crossing.first(Point<2>(1., 0.05), Point<2>(1., 1.)).has_value());
  // Along the boundary, touching it.
  BOOST_TEST(
    !crossing.first(Point<2>(0.5, 0.1), Point<2>(3., 0.1)).has_value());
  // The plate comes to the point.
  const Curve moved =
    curve.moved(unit_symmetric_tensor<2>(), Tensor<1, 2>(Point<2>(0., 2.)));
  const auto hit =
    CurveCrossing(curve, moved).first(Point<2>(1., 1.1), Point<2>(1., 1.1));
  BOOST_TEST(hit.has_value());
  BOOST_TEST(std::abs(hit->fraction - 0.5) < 1e-12);
}



// A circle is touched at the angle that geometry says; just above it, never.
BOOST_AUTO_TEST_CASE(grazing)
{
  const Curve         curve = circle(Point<2>(), 1.);
  const CurveCrossing crossing(curve);
  for (const double height : {0., 0.5, 0.9, 0.999, 0.999999})
    {
      const auto found =
        crossing.first(Point<2>(-2., height), Point<2>(2., height));
      BOOST_TEST(found.has_value());
      BOOST_TEST(std::abs(found->fraction -
                          (2. - std::sqrt(1. - height * height)) / 4.) < 1e-8);
    }
  BOOST_TEST(!crossing.first(Point<2>(-2., 1.000001), Point<2>(2., 1.000001))
                .has_value());
}



// Random paths against random rings that move and change their shape.
BOOST_AUTO_TEST_CASE(against_sampling)
{
  RandomCurves       random(41);
  const unsigned int n           = 300;
  unsigned int       n_crossings = 0;
  for (unsigned int trial = 0; trial < 60; ++trial)
    {
      const unsigned int n_nodes = 5 + trial % 6;
      const auto         first   = random.nodes(n_nodes, true);
      auto               last    = first;
      const Point<2>     shift   = random.point(-0.5, 0.5);
      for (auto &node : last)
        node += shift + random.point(-0.1, 0.1);
      const Curve    start = ring(first), end = ring(last);
      const Point<2> x = random.point(-4., 4.), X = random.point(-4., 4.);
      const double   expected = sampled_crossing(start, end, x, X, n);
      const auto     found    = CurveCrossing(start, end).first(x, X);
      if (expected < 1.5)
        {
          ++n_crossings;
          BOOST_TEST(found.has_value());
        }
      if (!found)
        continue;
      // Samples may step over a short stay within.
      BOOST_TEST(found->fraction <= expected);
      const Curve  curve = between(start, end, found->fraction);
      const double miss =
        (x + found->fraction * (X - x)).distance(curve.value(found->place));
      BOOST_TEST(miss < 1e-9);
      if (expected < 1.5)
        BOOST_TEST(expected - found->fraction < 1.01 / n);
    }
  BOOST_TEST(n_crossings > 15u);
}

BOOST_AUTO_TEST_SUITE_END()
