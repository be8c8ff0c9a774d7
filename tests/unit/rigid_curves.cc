#include <signorini/curves/c2_spline.h>
#include <signorini/curves/outline.h>
#include <signorini/input/input_error.h>

#include <boost/test/unit_test.hpp>

#include "random_curves.h"

BOOST_AUTO_TEST_SUITE(rigid_curves)

using namespace Signorini;
using namespace dealii;

namespace
{
  // d^n y/dt^n at an end of a segment, for the chord length t as parameter.
  Tensor<1, 2>
  derivative(const Curve       &curve,
             const unsigned int s,
             const double       xi,
             const unsigned int order)
  {
    const auto  &segment = curve.segment(s);
    const double step    = segment.control[0].distance(segment.control[3]);
    return order == 1 ? segment.derivative(xi) / step :
                        segment.second_derivative(xi) / (step * step);
  }

  double
  largest_radius_error(const Curve    &curve,
                       const Point<2> &centre,
                       const double    radius)
  {
    double error = 0.;
    for (unsigned int s = 0; s < curve.n_segments(); ++s)
      for (unsigned int i = 0; i <= 50; ++i)
        error = std::max(error,
                         std::abs(centre.distance(curve.value({s, i / 50.})) -
                                  radius) /
                           radius);
    return error;
  }
} // namespace



// Both derivatives go on across every joint, also across the last one of a
// ring.
BOOST_AUTO_TEST_CASE(continuous_curvature)
{
  RandomCurves random(31);
  double       first = 0., second = 0.;
  for (unsigned int trial = 0; trial < 60; ++trial)
    {
      const bool  is_closed = trial % 2;
      const auto  nodes     = random.nodes(3 + trial % 9, is_closed);
      const Curve curve     = c2_spline(nodes, is_closed, 180.);
      for (unsigned int s = 0; s < curve.n_segments(); ++s)
        {
          BOOST_TEST(curve.value({s, 0.}).distance(nodes[s]) == 0.);
          if (!curve.has_next(s))
            continue;
          const unsigned int next = curve.next(s);
          first                   = std::max(first,
                           (derivative(curve, s, 1., 1) -
                            derivative(curve, next, 0., 1))
                             .norm());
          second                  = std::max(second,
                            (derivative(curve, s, 1., 2) -
                             derivative(curve, next, 0., 2))
                              .norm());
        }
      if (!is_closed)
        {
          BOOST_TEST(derivative(curve, 0, 0., 2).norm() < 1e-12);
          BOOST_TEST(derivative(curve, curve.n_segments() - 1, 1., 2).norm() <
                     1e-12);
        }
    }
  BOOST_TEST_MESSAGE("jumps of y' and y'': " << first << ' ' << second);
  BOOST_TEST(first < 1e-13);
  BOOST_TEST(second < 1e-11);
}



// Clamped to its own tangents, a parabola or cubic is reproduced; a spline on a
// circle converges with the fourth order.
BOOST_AUTO_TEST_CASE(spline_accuracy)
{
  std::vector<Point<2>>                      nodes;
  std::array<std::optional<Tensor<1, 2>>, 2> tangents;
  for (const double x : {0., 0.7, 1., 2.5})
    nodes.emplace_back(x, 0.);
  tangents[0] = tangents[1] = Tensor<1, 2>(Point<2>(1., 0.));
  const Curve line          = c2_spline(nodes, false, 180., tangents);
  for (unsigned int s = 0; s < 3; ++s)
    BOOST_TEST((derivative(line, s, 0.3, 1) - *tangents[0]).norm() < 1e-14);
  tangents[0] = Tensor<1, 2>(Point<2>(0.6, 0.8));
  BOOST_TEST(
    (c2_spline(nodes, false, 180., tangents).tangent({0, 0.}) - *tangents[0])
      .norm() < 1e-14);

  double last = 0.;
  for (const unsigned int n : {8u, 16u, 32u})
    {
      std::vector<Point<2>> ring;
      for (unsigned int i = 0; i < n; ++i)
        ring.emplace_back(std::cos(2. * numbers::PI * i / n),
                          std::sin(2. * numbers::PI * i / n));
      const double error =
        largest_radius_error(c2_spline(ring, true, 180.), Point<2>(), 1.);
      BOOST_TEST_MESSAGE("C2 spline, " << n << " nodes: " << error);
      if (n > 8)
        BOOST_TEST(std::abs(std::log2(last / error) - 4.) < 0.2);
      last = error;
    }
}



// Where the polygon turns sharply the spline does so, too, and nowhere else.
BOOST_AUTO_TEST_CASE(spline_corners)
{
  const std::vector<Point<2>> square = {Point<2>(0., 0.),
                                        Point<2>(1., 0.),
                                        Point<2>(1., 1.),
                                        Point<2>(0., 1.)};
  const Curve                 broken = c2_spline(square, true, 60.);
  for (unsigned int s = 0; s < 4; ++s)
    {
      BOOST_TEST(broken.is_corner_after(s));
      BOOST_TEST(derivative(broken, s, 0.5, 2).norm() < 1e-14);
    }
  BOOST_TEST(std::abs(broken.enclosed_area() - 1.) < 1e-14);
  BOOST_TEST(std::abs(broken.reversed().enclosed_area() + 1.) < 1e-14);
  BOOST_TEST(std::abs(broken.length() - 4.) < 1e-12);
  const Curve round = c2_spline(square, true, 180.);
  BOOST_TEST(!round.is_corner_after(0));
  BOOST_TEST(round.enclosed_area() > 1.4);
}



// Arcs of all lengths and both directions, and a whole circle.
BOOST_AUTO_TEST_CASE(arcs)
{
  RandomCurves random(32);
  double       error = 0., middle_error = 0.;
  for (unsigned int trial = 0; trial < 200; ++trial)
    {
      const Point<2> centre = random.point(-1., 1.);
      const double   radius = random.number(0.1, 3.);
      const auto     at     = [&](const double angle) {
        return centre + radius * Point<2>(std::cos(angle), std::sin(angle));
      };
      const double start = random.number(0., 6.);
      const double sweep = random.number(0.1, 6.2) * (trial % 2 ? 1. : -1.);
      Outline      outline(at(start));
      if (trial % 4 < 2)
        outline.arc_through(at(start + 0.3 * sweep), at(start + sweep));
      else
        outline.arc_about(centre, at(start + sweep), sweep > 0.);
      const Curve curve = outline.curve(false, 1.);
      error = std::max(error, largest_radius_error(curve, centre, radius));
      BOOST_TEST(std::abs(curve.length() / (radius * std::abs(sweep)) - 1.) <
                 1e-9);
      for (unsigned int s = 0; s < curve.n_segments(); ++s)
        BOOST_TEST(!curve.is_corner_after(s));
      const double turn = (curve.segment(0).control[3] - centre) *
                          curve.normal({0, 1.}) * (sweep > 0. ? 1. : -1.);
      middle_error = std::max(middle_error, std::abs(turn / radius - 1.));
    }
  const Curve whole = circle(Point<2>(1., 2.), 0.5);
  error = std::max(error, largest_radius_error(whole, Point<2>(1., 2.), 0.5));
  BOOST_TEST(whole.n_segments() == 60u);
  BOOST_TEST(whole.is_closed());
  BOOST_TEST(std::abs(whole.enclosed_area() / (numbers::PI * 0.25) - 1.) <
             1e-10);
  BOOST_TEST_MESSAGE("radius error of arcs: " << error << ", of normals "
                                              << middle_error);
  BOOST_TEST(error < 1e-10);
  BOOST_TEST(error > 1e-13); // it is a cubic, after all
}



BOOST_AUTO_TEST_CASE(refused)
{
  Outline outline(Point<2>(0., 0.));
  BOOST_CHECK_THROW(outline.line_to(Point<2>(0., 0.)), InputError);
  BOOST_CHECK_THROW(outline.arc_through(Point<2>(1., 0.), Point<2>(2., 0.)),
                    InputError);
  BOOST_CHECK_THROW(outline.arc_about(Point<2>(1., 0.), Point<2>(3., 0.), true),
                    InputError);
  BOOST_CHECK_THROW(outline.curve(false, 30.), InputError);
}

BOOST_AUTO_TEST_SUITE_END()
