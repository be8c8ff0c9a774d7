// How well curves through nodes follow smooth shapes, and how graded nodes
// spoil them.
#include <signorini/curves/curve_weights.h>

#include <deal.II/base/numbers.h>

#include <boost/test/unit_test.hpp>

BOOST_AUTO_TEST_SUITE(curve_accuracy)

using namespace Signorini;
using namespace dealii;

using Knots = CurveWeights::Knots;

namespace
{
  // Largest distance of a curve from the unit circle.
  double
  radius_error(const Curve &curve)
  {
    double error = 0.;
    for (unsigned int s = 0; s < curve.n_segments(); ++s)
      for (unsigned int i = 0; i <= 40; ++i)
        error =
          std::max(error, std::abs(curve.value({s, i / 40.}).norm() - 1.));
    return error;
  }

  // Nodes on the unit circle, every other gap wider by a ratio.
  std::vector<Point<2>>
  on_a_circle(const unsigned int n, const double ratio)
  {
    std::vector<Point<2>> nodes;
    for (unsigned int i = 0; i < n; ++i)
      {
        const double s     = i + (i % 2) * (ratio - 1.) / (ratio + 1.);
        const double angle = 2. * numbers::PI * s / n;
        nodes.emplace_back(std::cos(angle), std::sin(angle));
      }
    return nodes;
  }
} // namespace



// A circle of 8 to 64 nodes: the error of the radius and its order.
BOOST_AUTO_TEST_CASE(circles)
{
  for (const double ratio : {1., 2.})
    {
      std::array<double, 3> last = {};
      for (const unsigned int n : {8u, 16u, 32u, 64u})
        {
          const auto                  nodes = on_a_circle(n, ratio);
          const std::array<double, 3> error = {
            {radius_error(
               CurveWeights::overhauser(nodes, true, Knots::uniform, 180.)
                 .curve(nodes)),
             radius_error(
               CurveWeights::overhauser(nodes, true, Knots::centripetal, 180.)
                 .curve(nodes)),
             radius_error(CurveWeights::facets(nodes, true).curve(nodes))}};
          std::array<double, 3> order = {};
          for (unsigned int i = 0; i < 3; ++i)
            order[i] = std::log2(last[i] / error[i]);
          BOOST_TEST_MESSAGE("ratio "
                             << ratio << ", " << n << " nodes: uniform "
                             << error[0] << ", centripetal " << error[1]
                             << ", facets " << error[2] << "; orders "
                             << order[0] << ' ' << order[1] << ' ' << order[2]);
          if (n > 16)
            {
              BOOST_TEST(std::abs(order[2] - 2.) < 0.1);
              if (ratio == 1.)
                {
                  BOOST_TEST(std::abs(order[0] - 4.) < 0.1);
                  BOOST_TEST(std::abs(order[1] - 4.) < 0.1);
                }
            }
          last = error;
        }
    }
}



// A straight boundary of wide nodes goes on with narrow ones at a slope: how
// far the curve leaves the polygon, over the narrow distance, and whether it
// turns back.
BOOST_AUTO_TEST_CASE(overshoot)
{
  for (const double ratio : {2., 5., 10., 20.})
    {
      std::vector<Point<2>> nodes;
      for (int i = -3; i <= 0; ++i)
        nodes.emplace_back(i, 0.);
      for (int i = 1; i <= 4; ++i)
        nodes.emplace_back(i / ratio, 0.2 * i / ratio);
      std::array<double, 2> distance = {}, backwards = {};
      for (const bool is_centripetal : {false, true})
        {
          const Curve curve =
            CurveWeights::overhauser(nodes,
                                     false,
                                     is_centripetal ? Knots::centripetal :
                                                      Knots::uniform,
                                     180.)
              .curve(nodes);
          for (unsigned int s = 0; s < curve.n_segments(); ++s)
            {
              const Tensor<1, 2> chord = nodes[s + 1] - nodes[s];
              for (unsigned int i = 0; i <= 100; ++i)
                {
                  const Tensor<1, 2> arm =
                    curve.value({s, i / 100.}) - nodes[s];
                  const double       along = arm * chord / chord.norm_square();
                  const Tensor<1, 2> off =
                    arm - std::clamp(along, 0., 1.) * chord;
                  distance[is_centripetal] =
                    std::max(distance[is_centripetal], off.norm() * ratio);
                  backwards[is_centripetal] =
                    std::max(backwards[is_centripetal],
                             -curve.tangent({s, i / 100.}) * chord /
                               chord.norm());
                }
            }
        }
      BOOST_TEST_MESSAGE("ratio " << ratio << ": off the polygon, over the "
                                  << "narrow distance: uniform " << distance[0]
                                  << ", centripetal " << distance[1]
                                  << "; turns back: " << backwards[0] << ", "
                                  << backwards[1]);
      BOOST_TEST(distance[1] < distance[0]);
      BOOST_TEST(backwards[1] == 0.);
      if (ratio >= 10.)
        BOOST_TEST(backwards[0] > 0.7);
    }
}

BOOST_AUTO_TEST_SUITE_END()
