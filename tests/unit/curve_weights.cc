#include <signorini/curves/curve_weights.h>
#include <signorini/input/input_error.h>

#include <deal.II/base/numbers.h>

#include <boost/test/unit_test.hpp>

#include <random>

BOOST_AUTO_TEST_SUITE(curve_weights)

using namespace Signorini;
using namespace dealii;

using Knots = CurveWeights::Knots;

namespace
{
  std::mt19937 generator(3);

  double
  random(const double from, const double to)
  {
    return std::uniform_real_distribution<double>(from, to)(generator);
  }

  // Nodes of uneven distance, bent by noise, open or round.
  std::vector<Point<2>>
  random_nodes(const unsigned int n, const bool is_closed)
  {
    std::vector<Point<2>> nodes;
    double                s = 0.;
    for (unsigned int i = 0; i < n; ++i)
      {
        s += random(0.3, 2.);
        nodes.emplace_back(s, random(-0.5, 0.5));
      }
    const double whole = s + 1.;
    if (is_closed)
      for (auto &node : nodes)
        {
          const double angle  = 2. * numbers::PI * node[0] / whole;
          const double radius = 2. + 0.3 * node[1];
          node = Point<2>(radius * std::cos(angle), radius * std::sin(angle));
        }
    return nodes;
  }

  // y or y' from the nodes.
  Tensor<1, 2>
  combine(const NodalWeights              &weights,
          const std::vector<Tensor<1, 2>> &phi,
          const std::vector<Point<2>>     &nodes)
  {
    Tensor<1, 2> sum;
    for (unsigned int j = 0; j < weights.nodes.size(); ++j)
      for (unsigned int c = 0; c < 2; ++c)
        sum[c] += phi[j][c] * nodes[weights.nodes[j]][c];
    return sum;
  }

  std::array<CurveEnd, 2>
  symmetric_ends(const unsigned int component)
  {
    CurveEnd end;
    end.kind               = CurveEndKind::symmetric;
    end.mirrored_component = component;
    return {{end, end}};
  }

  struct Family
  {
    CurveWeights          weights;
    std::vector<Point<2>> nodes;
  };

  // All sorts of chains, also the shortest ones.
  std::vector<Family>
  families()
  {
    std::vector<Family> list;
    for (const unsigned int n : {2u, 3u, 4u, 5u, 9u, 20u})
      for (const bool is_closed : {false, true})
        for (unsigned int trial = 0; trial < 10; ++trial)
          {
            if (is_closed && n < 3)
              continue;
            const auto nodes = random_nodes(n, is_closed);
            list.push_back({CurveWeights::facets(nodes, is_closed), nodes});
            for (const Knots knots : {Knots::uniform, Knots::centripetal})
              {
                for (const double angle : {180., 30.})
                  list.push_back(
                    {CurveWeights::overhauser(nodes, is_closed, knots, angle),
                     nodes});
                if (!is_closed)
                  for (const unsigned int c : {0u, 1u})
                    list.push_back(
                      {CurveWeights::overhauser(
                         nodes, false, knots, 60., symmetric_ends(c)),
                       nodes});
              }
          }
    return list;
  }
} // namespace



// sum phi = 1, sum phi' = 0, and both give the curve and its derivative, also
// after the nodes have moved away from the positions that gave the knots.
BOOST_AUTO_TEST_CASE(reproduce_the_curve)
{
  double unity = 0., place = 0., slope = 0.;
  for (const auto &[weights, reference] : families())
    {
      auto nodes = reference;
      for (auto &node : nodes)
        node += Point<2>(random(-0.1, 0.1), random(-0.1, 0.1));
      Curve curve = weights.curve(reference);
      weights.update(nodes, curve);
      for (unsigned int s = 0; s < curve.n_segments(); ++s)
        for (const double xi : {0., 0.13, 0.5, 0.77, 1.})
          {
            const NodalWeights at = weights.at({s, xi});
            BOOST_TEST(at.nodes.size() <= 4u);
            Tensor<1, 2> sum, dsum;
            for (unsigned int j = 0; j < at.nodes.size(); ++j)
              {
                sum += at.phi[j];
                dsum += at.dphi[j];
              }
            for (unsigned int c = 0; c < 2; ++c)
              unity =
                std::max({unity, std::abs(sum[c] - 1.), std::abs(dsum[c])});
            place = std::max(
              place,
              (combine(at, at.phi, nodes) - curve.value({s, xi})).norm());
            slope = std::max(slope,
                             (combine(at, at.dphi, nodes) -
                              curve.segment(s).derivative(xi))
                               .norm());
          }
      const unsigned int n = nodes.size();
      for (unsigned int s = 0; s < curve.n_segments(); ++s)
        {
          BOOST_TEST(curve.value({s, 0.}).distance(nodes[s]) < 1e-13);
          BOOST_TEST(curve.value({s, 1.}).distance(nodes[(s + 1) % n]) < 1e-13);
        }
    }
  BOOST_TEST_MESSAGE("weights: " << unity << ' ' << place << ' ' << slope);
  BOOST_TEST(unity < 1e-14);
  BOOST_TEST(place < 2e-14);
  BOOST_TEST(slope < 5e-14);
}



// Joints that are no corners have one tangent on both sides; with equal speed
// where knots are uniform.
BOOST_AUTO_TEST_CASE(smooth_joints)
{
  unsigned int n_smooth = 0, n_corners = 0;
  for (const auto &[weights, nodes] : families())
    {
      const Curve curve = weights.curve(nodes);
      for (unsigned int s = 0; s < curve.n_segments(); ++s)
        if (curve.has_next(s))
          {
            const unsigned int next = curve.next(s);
            if (curve.is_corner_after(s))
              ++n_corners;
            else
              {
                ++n_smooth;
                BOOST_TEST(
                  (curve.tangent({s, 1.}) - curve.tangent({next, 0.})).norm() <
                  1e-13);
              }
          }
    }
  BOOST_TEST(n_smooth > 1000u);
  BOOST_TEST(n_corners > 500u);
}



// The weights in the middle of a uniform chain are those of [MC, eq. 33].
BOOST_AUTO_TEST_CASE(catmull_rom)
{
  const auto nodes = random_nodes(8, false);
  const auto uniform =
    CurveWeights::overhauser(nodes, false, Knots::uniform, 180.);
  for (const double u : {0., 0.2, 0.5, 0.9, 1.})
    {
      const NodalWeights at         = uniform.at({3, u});
      const double       expected[] = {-0.5 * u * u * u + u * u - 0.5 * u,
                                       1.5 * u * u * u - 2.5 * u * u + 1.,
                                       -1.5 * u * u * u + 2. * u * u + 0.5 * u,
                                       0.5 * u * u * u - 0.5 * u * u};
      BOOST_TEST(at.nodes == std::vector<unsigned int>({2, 3, 4, 5}),
                 boost::test_tools::per_element());
      for (unsigned int j = 0; j < 4; ++j)
        for (unsigned int c = 0; c < 2; ++c)
          BOOST_TEST(std::abs(at.phi[j][c] - expected[j]) < 1e-15);
    }
  // On equal distances the centripetal knots say the same.
  std::vector<Point<2>> even;
  for (unsigned int i = 0; i < 8; ++i)
    even.emplace_back(0.7 * i, 0.);
  const auto centripetal =
    CurveWeights::overhauser(even, false, Knots::centripetal, 180.);
  for (unsigned int s = 0; s < 7; ++s)
    for (unsigned int j = 0; j < uniform.at({s, 0.3}).phi.size(); ++j)
      BOOST_TEST(
        (centripetal.at({s, 0.3}).phi[j] - uniform.at({s, 0.3}).phi[j]).norm() <
        1e-14);
}



// Ends are parabolas: a chain through points of one is exact up to its ends.
BOOST_AUTO_TEST_CASE(parabolas)
{
  std::vector<Point<2>> nodes;
  for (int i = -3; i <= 3; ++i)
    nodes.emplace_back(i, 0.1 * i * i);
  const Curve curve =
    CurveWeights::overhauser(nodes, false, Knots::uniform, 180.).curve(nodes);
  for (unsigned int s = 0; s < curve.n_segments(); ++s)
    for (const double xi : {0.1, 0.5, 0.8})
      {
        const Point<2> y = curve.value({s, xi});
        BOOST_TEST(std::abs(y[0] - (s + xi - 3.)) < 1e-14);
        BOOST_TEST(std::abs(y[1] - 0.1 * y[0] * y[0]) < 1e-14);
      }
}



// At a symmetric end the normal lies in the line of symmetry to the last bit,
// however the other nodes stand.
BOOST_AUTO_TEST_CASE(symmetric_end)
{
  for (unsigned int trial = 0; trial < 200; ++trial)
    for (const Knots knots : {Knots::uniform, Knots::centripetal})
      for (const unsigned int c : {0u, 1u})
        {
          const auto nodes   = random_nodes(2 + trial % 6, false);
          const auto weights = CurveWeights::overhauser(
            nodes, false, knots, 180., symmetric_ends(c));
          const Curve curve = weights.curve(nodes);
          BOOST_TEST(std::abs(curve.normal({0, 0.})[c]) < 1e-15);
          BOOST_TEST(std::abs(curve.normal({curve.n_segments() - 1, 1.})[c]) <
                     1e-15);
        }
}



// Only the segments that hang on a node move with it.
BOOST_AUTO_TEST_CASE(local_support)
{
  for (const auto &[weights, reference] : families())
    {
      const Curve before = weights.curve(reference);
      for (unsigned int n = 0; n < reference.size(); ++n)
        {
          auto nodes = reference;
          nodes[n] += Point<2>(0.3, 0.2);
          Curve all = before, some = before;
          weights.update(nodes, all);
          weights.update(nodes, weights.segments_of(n), some);
          for (unsigned int s = 0; s < all.n_segments(); ++s)
            BOOST_TEST(all.value({s, 0.4}).distance(some.value({s, 0.4})) ==
                       0.);
        }
    }
}



BOOST_AUTO_TEST_CASE(refused)
{
  const std::vector<Point<2>> one   = {Point<2>(0., 0.)};
  const std::vector<Point<2>> two   = {Point<2>(0., 0.), Point<2>(1., 0.)};
  const std::vector<Point<2>> twice = {Point<2>(0., 0.),
                                       Point<2>(1., 0.),
                                       Point<2>(1., 0.)};
  BOOST_CHECK_THROW(CurveWeights::facets(one, false), InputError);
  BOOST_CHECK_THROW(CurveWeights::facets(two, true), InputError);
  BOOST_CHECK_THROW(CurveWeights::overhauser(twice, false, Knots::uniform, 30.),
                    InputError);
}

BOOST_AUTO_TEST_SUITE_END()
