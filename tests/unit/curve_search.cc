#include <signorini/curves/c2_spline.h>
#include <signorini/curves/curve_search.h>
#include <signorini/curves/outline.h>

#include <boost/test/unit_test.hpp>

#include "random_curves.h"

BOOST_AUTO_TEST_SUITE(curve_search)

using namespace Signorini;
using namespace dealii;

using Knots = CurveWeights::Knots;

namespace
{
  // The distance from a curve by samples, and golden sections around those
  // that the least one does not exclude.
  double
  sampled_distance(const Curve &curve, const Point<2> &x)
  {
    constexpr unsigned int n = 24;
    const auto distance      = [&](const unsigned int s, const double xi) {
      return x.distance(curve.value({s, xi}));
    };
    std::vector<double> samples;
    for (unsigned int s = 0; s < curve.n_segments(); ++s)
      for (unsigned int i = 0; i <= n; ++i)
        samples.push_back(distance(s, i / double(n)));
    double least = *std::min_element(samples.begin(), samples.end());
    for (unsigned int k = 0; k < samples.size(); ++k)
      {
        const unsigned int s = k / (n + 1), i = k % (n + 1);
        const double       next = samples[i == n ? k : k + 1];
        const double       last = samples[i == 0 ? k : k - 1];
        if (samples[k] > next || samples[k] > last ||
            samples[k] > least + std::abs(next - samples[k]) +
                           std::abs(last - samples[k]) + 0.05)
          continue;
        double low  = std::max(0., (i - 1.) / n);
        double high = std::min(1., (i + 1.) / n);
        for (unsigned int step = 0; step < 50; ++step)
          {
            const double a         = low + 0.382 * (high - low);
            const double b         = low + 0.618 * (high - low);
            const bool   is_left   = distance(s, a) < distance(s, b);
            (is_left ? high : low) = is_left ? b : a;
          }
        least = std::min(least, distance(s, 0.5 * (low + high)));
      }
    return least;
  }

  // Every other node is on an arc between its neighbours.
  Curve
  arcs(const std::vector<Point<2>> &nodes, const bool is_closed)
  {
    Outline outline(nodes[0]);
    for (unsigned int i = 1; i + 1 < nodes.size(); i += 2)
      outline.arc_through(nodes[i], nodes[i + 1]);
    return outline.curve(is_closed, 30.);
  }

  Curve
  random_curve(RandomCurves &random, const unsigned int trial)
  {
    const bool is_closed = trial % 2 == 0;
    const auto nodes     = random.nodes(3 + trial % 11, is_closed);
    switch (trial % 7)
      {
        case 0:
          return CurveWeights::facets(nodes, is_closed).curve(nodes);
        case 1:
          return c2_spline(nodes, is_closed, trial % 3 ? 180. : 40.);
        case 2:
          return arcs(nodes, is_closed);
        case 3:
        case 4:
          return CurveWeights::overhauser(nodes,
                                          is_closed,
                                          Knots::uniform,
                                          trial % 3 ? 180. : 40.)
            .curve(nodes);
        default:
          return CurveWeights::overhauser(nodes,
                                          is_closed,
                                          Knots::centripetal,
                                          trial % 3 ? 180. : 40.)
            .curve(nodes);
      }
  }

  Curve
  square(const double feature_angle = 30.)
  {
    const std::vector<Point<2>> nodes = {Point<2>(0., 0.),
                                         Point<2>(1., 0.),
                                         Point<2>(1., 1.),
                                         Point<2>(0., 1.)};
    return CurveWeights::overhauser(nodes, true, Knots::uniform, feature_angle)
      .curve(nodes);
  }

  Tensor<1, 2>
  direction(const double x, const double y)
  {
    return Point<2>(x, y) / std::hypot(x, y);
  }
} // namespace



// 220 curves and 40 points each, on them, near and far: nothing is nearer.
BOOST_AUTO_TEST_CASE(brute_force)
{
  RandomCurves random(11);
  double       error = 0., skew = 0.;
  unsigned int n_found = 0, n_none = 0, n_vertices = 0;
  for (unsigned int trial = 0; trial < 220; ++trial)
    {
      const Curve       curve = random_curve(random, trial);
      const CurveSearch search(curve);
      for (unsigned int i = 0; i < 40; ++i)
        {
          Point<2>           x = random.point(-3., 3.);
          const unsigned int s = random.number(0., curve.n_segments());
          const double       t = random.number(0., 1.);
          if (i % 4 == 0)
            x = curve.value({s, t});
          else if (i % 4 == 1)
            x = curve.value({s, t}) +
                random.number(-1e-3, 1e-3) * curve.normal({s, t});
          else if (i % 4 == 2)
            x *= 10.;
          const auto   found   = search.project(x);
          const double nearest = sampled_distance(curve, x);
          if (!found)
            {
              ++n_none;
              BOOST_TEST(!curve.is_closed());
              continue;
            }
          ++n_found;
          n_vertices += found->is_vertex;
          // Beyond a free end nothing counts, so that the rest may be farther.
          const double end =
            curve.is_closed() ?
              1e300 :
              std::min(x.distance(curve.value({0, 0.})),
                       x.distance(curve.value({curve.n_segments() - 1, 1.})));
          if (end > nearest * (1. + 1e-9) + 1e-9)
            error = std::max(error, std::abs(std::abs(found->gap) - nearest));
          const Tensor<1, 2> arm = x - found->point;
          skew = std::max(skew, (arm - found->gap * found->normal).norm());
          BOOST_TEST(std::abs(found->normal.norm() - 1.) < 1e-14);
        }
    }
  BOOST_TEST_MESSAGE("found " << n_found << ", none " << n_none << ", vertices "
                              << n_vertices << "; error of the distance "
                              << error << ", of the foot " << skew);
  BOOST_TEST(n_found > 6500u);
  BOOST_TEST(n_vertices > 200u);
  BOOST_TEST(error < 1e-7); // of the golden sections: |x - y| is flat there
  BOOST_TEST(skew < 1e-10);
}



// With the filters of a query the answer is the nearest of all local minima
// that pass them.
BOOST_AUTO_TEST_CASE(filters)
{
  RandomCurves random(13);
  unsigned int n_found = 0;
  for (unsigned int trial = 0; trial < 100; ++trial)
    {
      const Curve       curve = random_curve(random, trial);
      const CurveSearch search(curve);
      for (unsigned int i = 0; i < 30; ++i)
        {
          const Point<2> x = random.point(-3., 3.);
          CurveQuery     query;
          query.search_distance   = random.number(0.1, 3.);
          query.penetration_limit = random.number(0.1, 1.);
          query.contactor_normal =
            direction(random.number(-1., 1.), random.number(-1., 1.));
          std::vector<CurveProjection> places;
          for (unsigned int s = 0; s < curve.n_segments(); ++s)
            find_nearest_places(curve, s, x, places);
          double all = 1e300, all_gap = 0., allowed = 1e300;
          for (const auto &place : places)
            if (std::abs(place.gap) < all)
              {
                all     = std::abs(place.gap);
                all_gap = place.gap;
              }
          for (const auto &place : places)
            if (std::abs(place.gap) <= query.search_distance &&
                place.gap >= -query.penetration_limit &&
                *query.contactor_normal * place.normal < -0.1 &&
                (place.gap >= 0. || all_gap <= 0.))
              allowed = std::min(allowed, std::abs(place.gap));
          const auto found = search.project(x, query);
          BOOST_TEST(found.has_value() == (allowed < 1e300));
          n_found += found.has_value();
          if (found)
            BOOST_TEST(std::abs(std::abs(found->gap) - allowed) < 1e-12);
        }
    }
  BOOST_TEST(n_found > 500u);
}



// Where the nearest point is unique the gap has no jump as x moves, and never
// changes by more than x; also round corners and through the body's boundary.
BOOST_AUTO_TEST_CASE(continuity)
{
  RandomCurves random(14);
  for (unsigned int trial = 0; trial < 100; trial += 2) // closed ones
    {
      const Curve        curve = random_curve(random, trial);
      const CurveSearch  search(curve);
      const Point<2>     start = random.point(-3., 3.);
      const Point<2>     end   = random.point(-3., 3.);
      const unsigned int n     = 400;
      double             last  = search.project(start)->gap;
      for (unsigned int i = 1; i <= n; ++i)
        {
          const auto found =
            search.project(start + i / double(n) * (end - start));
          BOOST_TEST(std::abs(found->gap - last) <=
                     start.distance(end) / n * (1. + 1e-9));
          last = found->gap;
        }
    }
}



// A square: its normal cones outside, its nearer side inside.
BOOST_AUTO_TEST_CASE(corners)
{
  const Curve       curve = square();
  const CurveSearch search(curve);
  const auto        vertex = search.project(Point<2>(1.3, 1.4));
  BOOST_TEST(vertex->is_vertex);
  BOOST_TEST(std::abs(vertex->gap - 0.5) < 1e-15);
  BOOST_TEST((vertex->normal - direction(0.3, 0.4)).norm() < 1e-15);
  // At the vertex itself the middle of the cone.
  const auto middle = search.project(Point<2>(1., 1.));
  BOOST_TEST((middle->normal - direction(1., 1.)).norm() < 1e-15);
  BOOST_TEST(middle->gap == 0.);
  // Just inside, past the corner.
  const auto side = search.project(Point<2>(0.99, 0.98));
  BOOST_TEST(!side->is_vertex);
  BOOST_TEST(std::abs(side->gap + 0.01) < 1e-15);
  BOOST_TEST((side->normal - direction(1., 0.)).norm() < 1e-15);
  // The contactor's normal decides for the other side.
  CurveQuery query;
  query.contactor_normal = direction(0., -1.);
  const auto top         = search.project(Point<2>(0.99, 0.98), query);
  BOOST_TEST(std::abs(top->gap + 0.02) < 1e-15);
  BOOST_TEST((top->normal - direction(0., 1.)).norm() < 1e-15);
}



// Behind a thin body: the far side faces the contactor, but x is outside.
BOOST_AUTO_TEST_CASE(thin_body)
{
  std::vector<Point<2>> nodes = {Point<2>(0., 0.),
                                 Point<2>(4., 0.),
                                 Point<2>(4., 0.1),
                                 Point<2>(0., 0.1)};
  const Curve           curve = CurveWeights::facets(nodes, true).curve(nodes);
  const CurveSearch     search(curve);
  CurveQuery            query;
  query.contactor_normal = direction(0., 1.); // looks up, stands above
  BOOST_TEST(!search.project(Point<2>(2., 0.15), query).has_value());
  // More than half through from below, it still belongs to the lower side.
  const auto through = search.project(Point<2>(2., 0.08), query);
  BOOST_TEST(through.has_value());
  BOOST_TEST(std::abs(through->gap + 0.08) < 1e-15);
  query.penetration_limit = 0.05;
  BOOST_TEST(!search.project(Point<2>(2., 0.08), query).has_value());
}



// A straight curve from (1, 0) to (0, 0), its body below.
BOOST_AUTO_TEST_CASE(open_ends)
{
  const std::vector<Point<2>> nodes = {Point<2>(1., 0.), Point<2>(0., 0.)};
  Curve             curve = CurveWeights::facets(nodes, false).curve(nodes);
  const CurveSearch search(curve);
  BOOST_TEST(std::abs(search.project(Point<2>(0.2, 0.3))->gap - 0.3) < 1e-15);
  BOOST_TEST(!search.project(Point<2>(-0.1, 0.3)).has_value());
  BOOST_TEST(!search.project(Point<2>(-0.1, -0.3)).has_value());
  // Over the end but for rounding.
  BOOST_TEST(search.project(Point<2>(-1e-9, 0.3)).has_value());

  CurveEnd corner;
  corner.kind   = CurveEndKind::corner;
  corner.normal = direction(-1., 0.);
  curve.set_end(1, corner);
  corner.normal = direction(1., 0.);
  curve.set_end(0, corner);
  const auto left = search.project(Point<2>(-0.3, 0.4));
  BOOST_TEST(left->is_vertex);
  BOOST_TEST(std::abs(left->gap - 0.5) < 1e-15);
  BOOST_TEST(
    (search.project(Point<2>(1.3, 0.4))->normal - direction(3., 4.)).norm() <
    1e-15);
  BOOST_TEST(!search.project(Point<2>(-0.3, -0.1)).has_value());

  CurveEnd symmetric;
  symmetric.kind = CurveEndKind::symmetric;
  curve.set_end(1, symmetric);
  const auto beyond = search.project(Point<2>(-1e-3, 0.25));
  BOOST_TEST(beyond->gap == 0.25);
  BOOST_TEST((beyond->normal - direction(0., 1.)).norm() == 0.);
}



// A node of the boundary itself does not see the segments beside it.
BOOST_AUTO_TEST_CASE(self_contact)
{
  // A hook: two legs with a slit of 0.2 between them.
  const std::vector<Point<2>> nodes   = {Point<2>(0., 0.),
                                         Point<2>(1., 0.),
                                         Point<2>(2., 0.),
                                         Point<2>(2., 0.2),
                                         Point<2>(1., 0.2),
                                         Point<2>(0., 0.2)};
  const auto                  weights = CurveWeights::facets(nodes, false);
  const Curve                 curve   = weights.curve(nodes);
  const CurveSearch           search(curve);
  CurveQuery                  query;
  const auto                  own = weights.segments_of(1);
  query.is_excluded               = [&](const unsigned int s) {
    return std::find(own.begin(), own.end(), s) != own.end();
  };
  query.contactor_normal = direction(0., -1.);
  const auto found       = search.project(nodes[1], query);
  BOOST_TEST(found.has_value());
  BOOST_TEST(found->point.distance(nodes[4]) < 1e-15);
}

BOOST_AUTO_TEST_SUITE_END()
