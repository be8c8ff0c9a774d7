#include <signorini/curves/curve_search.h>
#include <signorini/curves/gap_derivatives.h>

#include <boost/test/unit_test.hpp>

#include "random_curves.h"
#include <Sacado.hpp>

BOOST_AUTO_TEST_SUITE(gap_derivatives)

using namespace Signorini;
using namespace dealii;

namespace
{
  // Second derivatives by differentiating the type twice.
  using Single = Sacado::Fad::DFad<double>;
  using Double = Sacado::Fad::DFad<Single>;

  struct Unknowns
  {
    std::vector<Double> u; // x, then the nodes
  };

  // The Bernstein sum of nodes with the weights of a place that itself depends
  // on the unknowns; derivative 0, 1 or 2 to xi.
  std::array<Double, 2>
  evaluate(const CurveWeights        &weights,
           const unsigned int         segment,
           const std::vector<Double> &u,
           const Double              &xi,
           const unsigned int         derivative)
  {
    // Control points are the curve's values as linear combinations: recover
    // the weights of the Bernstein form from four places.
    std::array<NodalWeights, 4> at;
    for (unsigned int i = 0; i < 4; ++i)
      at[i] = weights.at({segment, i / 3.});
    std::array<Double, 2> sum = {{Double(0.), Double(0.)}};
    for (unsigned int i = 0; i < 4; ++i)
      {
        // Lagrange's polynomial of the place i/3, and its derivatives.
        const double other[3] = {(i == 0 ? 1 : 0) / 3.,
                                 (i <= 1 ? 2 : 1) / 3.,
                                 (i <= 2 ? 3 : 2) / 3.};
        const double denominator =
          (i / 3. - other[0]) * (i / 3. - other[1]) * (i / 3. - other[2]);
        const Double a = xi - other[0], b = xi - other[1], c = xi - other[2];
        Double       value;
        if (derivative == 0)
          value = a * b * c / denominator;
        else if (derivative == 1)
          value = (a * b + b * c + a * c) / denominator;
        else
          value = 2. * (a + b + c) / denominator;
        for (unsigned int j = 0; j < at[i].nodes.size(); ++j)
          for (unsigned int d = 0; d < 2; ++d)
            sum[d] += value * at[i].phi[j][d] * u[2 + 2 * j + d];
      }
    return sum;
  }

  // g of the unknowns. Newton's method in the differentiated type, from the
  // solution: each step makes one more order of derivatives right.
  Double
  gap(const CurveWeights        &weights,
      const CurveProjection     &projection,
      const std::vector<Double> &u)
  {
    Double xi = projection.xi;
    for (unsigned int step = 0; step < 4; ++step)
      {
        const auto y   = evaluate(weights, projection.segment, u, xi, 0);
        const auto dy  = evaluate(weights, projection.segment, u, xi, 1);
        const auto ddy = evaluate(weights, projection.segment, u, xi, 2);
        Double     f = 0., slope = 0.;
        for (unsigned int d = 0; d < 2; ++d)
          {
            f += (u[d] - y[d]) * dy[d];
            slope += (u[d] - y[d]) * ddy[d] - dy[d] * dy[d];
          }
        xi = xi - f / slope;
      }
    const auto   y     = evaluate(weights, projection.segment, u, xi, 0);
    const auto   dy    = evaluate(weights, projection.segment, u, xi, 1);
    const Double speed = sqrt(dy[0] * dy[0] + dy[1] * dy[1]);
    return ((u[0] - y[0]) * dy[1] - (u[1] - y[1]) * dy[0]) / speed;
  }

  std::vector<Double>
  unknowns(const Point<2>              &x,
           const std::vector<Point<2>> &nodes,
           const NodalWeights          &weights)
  {
    std::vector<double> values = {x[0], x[1]};
    for (const unsigned int node : weights.nodes)
      for (unsigned int d = 0; d < 2; ++d)
        values.push_back(nodes[node][d]);
    std::vector<Double> u(values.size());
    for (unsigned int i = 0; i < values.size(); ++i)
      u[i] = Double(values.size(), i, Single(values.size(), i, values[i]));
    return u;
  }
} // namespace



// Gradient and Hessian over x and all nodes, for knots of both kinds and with
// symmetric ends, for gaps of both signs.
BOOST_AUTO_TEST_CASE(against_sacado)
{
  RandomCurves            random(21);
  std::array<CurveEnd, 2> ends;
  ends[0].kind                = CurveEndKind::symmetric;
  ends[0].mirrored_component  = 0;
  ends[1].kind                = CurveEndKind::symmetric;
  ends[1].mirrored_component  = 1;
  double       gradient_error = 0., hessian_error = 0.;
  unsigned int n_checked = 0;
  for (unsigned int trial = 0; trial < 300; ++trial)
    {
      const bool is_closed = trial % 3 == 0;
      const auto nodes     = random.nodes(2 + is_closed + trial % 7, is_closed);
      const auto weights =
        CurveWeights::overhauser(nodes,
                                 is_closed,
                                 trial % 2 ? CurveWeights::Knots::uniform :
                                             CurveWeights::Knots::centripetal,
                                 180.,
                                 trial % 3 == 1 ? ends :
                                                  std::array<CurveEnd, 2>());
      const Curve       curve = weights.curve(nodes);
      const CurveSearch search(curve);
      const auto        s =
        static_cast<unsigned int>(random.number(0., curve.n_segments()));
      const CurveParameter place = {s, random.number(0.05, 0.95)};
      const Point<2>       x =
        curve.value(place) + random.number(-0.3, 0.3) * curve.normal(place);
      const auto found = search.project(x);
      if (!found || found->xi < 0.01 || found->xi > 0.99)
        continue;
      const double D =
        found->speed * found->speed - found->gap * found->curvature;
      if (D < 0.1 * found->speed * found->speed)
        continue;
      ++n_checked;
      const NodalWeights at     = weights.at(found->place());
      const auto         result = differentiate_gap(*found, at);
      const Double expected     = gap(weights, *found, unknowns(x, nodes, at));
      double       largest      = 1.;
      for (unsigned int i = 0; i < result.gap.size(); ++i)
        for (unsigned int j = 0; j < result.gap.size(); ++j)
          largest = std::max(largest, std::abs(result.hessian(i, j)));
      BOOST_TEST(std::abs(expected.val().val() - found->gap) < 1e-12);
      for (unsigned int i = 0; i < result.gap.size(); ++i)
        {
          gradient_error =
            std::max(gradient_error,
                     std::abs(result.gap[i] - expected.dx(i).val()));
          for (unsigned int j = 0; j < result.gap.size(); ++j)
            hessian_error =
              std::max(hessian_error,
                       std::abs(result.hessian(i, j) - expected.dx(i).dx(j)) /
                         largest);
        }
    }
  BOOST_TEST_MESSAGE(n_checked << " Hessians, relative error " << hessian_error
                               << ", gradient " << gradient_error);
  BOOST_TEST(n_checked > 150u);
  BOOST_TEST(gradient_error < 1e-12);
  BOOST_TEST(hessian_error < 1e-10);
}



// dxi by finite differences of the search.
BOOST_AUTO_TEST_CASE(parameter)
{
  RandomCurves random(22);
  const auto   nodes   = random.nodes(9, true);
  const auto   weights = CurveWeights::overhauser(
    nodes, true, CurveWeights::Knots::centripetal, 180.);
  const Curve          curve = weights.curve(nodes);
  const CurveParameter place = {4, 0.4};
  const Point<2>       x     = curve.value(place) + 0.1 * curve.normal(place);
  const auto           found = CurveSearch(curve).project(x);
  const NodalWeights   at    = weights.at(found->place());
  const auto           rows  = differentiate_gap(*found, at);
  for (unsigned int i = 0; i < rows.parameter.size(); ++i)
    {
      double xi[2];
      for (const int side : {0, 1})
        {
          auto     moved   = nodes;
          Point<2> moved_x = x;
          (i < 2 ? moved_x[i] : moved[at.nodes[i / 2 - 1]][i % 2]) +=
            (side ? 1e-6 : -1e-6);
          const Curve other = weights.curve(moved);
          xi[side]          = CurveSearch(other).project(moved_x)->xi;
        }
      BOOST_TEST(std::abs((xi[1] - xi[0]) / 2e-6 - rows.parameter[i]) < 1e-8);
    }
}



// At a vertex the gap is the distance of two points, positive or negative.
BOOST_AUTO_TEST_CASE(vertex)
{
  const std::vector<Point<2>> nodes  = {Point<2>(2., 0.),
                                        Point<2>(0.5, 1.),
                                        Point<2>(-1., 0.)};
  std::vector<Point<2>>       valley = nodes;
  valley[1][1]                       = -1.;
  for (const auto &points : {nodes, valley})
    {
      const auto     weights = CurveWeights::facets(points, false);
      const Curve    curve   = weights.curve(points);
      const Point<2> x(0.55, points[1][1] * 1.5);
      const auto     found = CurveSearch(curve).project(x);
      BOOST_TEST(found.has_value());
      BOOST_TEST(found->is_vertex);
      const double       sign   = points[1][1] > 0. ? 1. : -1.;
      const NodalWeights at     = weights.at(found->place());
      const auto         u      = unknowns(x, points, at);
      const unsigned int node   = at.nodes[0] == 1 ? 0 : 1;
      const Double       a      = u[0] - u[2 + 2 * node];
      const Double       b      = u[1] - u[3 + 2 * node];
      const Double       g      = sign * sqrt(a * a + b * b);
      const auto         result = differentiate_gap(*found, at);
      BOOST_TEST(std::abs(found->gap - g.val().val()) < 1e-14);
      for (unsigned int i = 0; i < result.gap.size(); ++i)
        {
          BOOST_TEST(std::abs(result.gap[i] - g.dx(i).val()) < 1e-14);
          for (unsigned int j = 0; j < result.gap.size(); ++j)
            BOOST_TEST(std::abs(result.hessian(i, j) -
                                (g.dx(i).size() ? g.dx(i).dx(j) : 0.)) < 1e-13);
        }
    }
}

BOOST_AUTO_TEST_SUITE_END()
