#include <signorini/contact/contact_point.h>
#include <signorini/contact/contactor_surface.h>
#include <signorini/contact/plane.h>
#include <signorini/contact/sphere.h>

#include <deal.II/base/numbers.h>

#include <boost/test/unit_test.hpp>

#include <random>

#include "test_body.h"
#include <Sacado.hpp>

BOOST_AUTO_TEST_SUITE(rigid_surfaces)

using namespace Signorini;
using namespace dealii;

namespace
{
  // Second derivatives by differentiating the type twice.
  using Single = Sacado::Fad::DFad<double>;
  using Double = Sacado::Fad::DFad<Single>;

  template <int dim>
  struct Expected
  {
    double         gap;
    Tensor<1, dim> gradient;
    Tensor<2, dim> hessian;
  };

  // Gap, gradient and Hessian of a gap function, by Sacado.
  template <int dim, typename Gap>
  Expected<dim>
  differentiate(const Point<dim> &point, const Gap &gap)
  {
    std::array<Double, dim> x;
    for (unsigned int d = 0; d < dim; ++d)
      {
        x[d] = Double(dim, d, Single(dim, d, point[d]));
      }
    const Double  g = gap(x);
    Expected<dim> result;
    result.gap = g.val().val();
    for (unsigned int i = 0; i < dim; ++i)
      {
        result.gradient[i] = g.dx(i).val();
        for (unsigned int j = 0; j < dim; ++j)
          result.hessian[i][j] = g.dx(i).size() ? g.dx(i).dx(j) : 0.;
      }
    return result;
  }

  template <int dim, typename Gap>
  void
  compare(const RigidSurface<dim> &surface, const Gap &gap)
  {
    std::mt19937                           random(5);
    std::uniform_real_distribution<double> coordinate(-3., 3.);
    for (unsigned int trial = 0; trial < 50; ++trial)
      {
        Point<dim> point;
        for (unsigned int d = 0; d < dim; ++d)
          point[d] = coordinate(random);
        const auto expected = differentiate<dim>(point, gap);
        const auto found    = surface.closest(point);
        BOOST_TEST(std::abs(found.gap - expected.gap) < 1e-13);
        BOOST_TEST((found.normal - expected.gradient).norm() < 1e-13);
        BOOST_TEST((Tensor<2, dim>(found.curvature) - expected.hessian).norm() <
                   1e-11);
      }
  }
} // namespace



BOOST_AUTO_TEST_CASE(gradients_and_curvatures)
{
  Tensor<1, 2> normal;
  normal[0] = 3.;
  normal[1] = 4.;
  compare<2>(Plane<2>(Point<2>(0.1, 0.2), normal), [](const auto &x) {
    return Double(0.6 * (x[0] - 0.1) + 0.8 * (x[1] - 0.2));
  });
  for (const bool inside : {false, true})
    {
      const double sign = inside ? -1. : 1.;
      compare<2>(Sphere<2>(Point<2>(4., 1.), 0.7, Tensor<1, 2>(), inside),
                 [sign](const auto &x) {
                   const Double a = x[0] - 4., b = x[1] - 1.;
                   return Double(sign * (sqrt(a * a + b * b) - 0.7));
                 });
      compare<3>(Sphere<3>(Point<3>(4., 1., -5.), 0.7, Tensor<1, 3>(), inside),
                 [sign](const auto &x) {
                   const Double a = x[0] - 4., b = x[1] - 1., c = x[2] + 5.;
                   return Double(sign * (sqrt(a * a + b * b + c * c) - 0.7));
                 });
      Tensor<1, 3> axis;
      axis[2] = 2.;
      compare<3>(Sphere<3>(Point<3>(4., 1., -5.), 0.7, axis, inside),
                 [sign](const auto &x) {
                   const Double a = x[0] - 4., b = x[1] - 1.;
                   return Double(sign * (sqrt(a * a + b * b) - 0.7));
                 });
    }
}



// At the very centre a normal exists and is a unit vector.
BOOST_AUTO_TEST_CASE(centre_of_a_circle)
{
  const auto found = Sphere<2>(Point<2>(1., 1.), 2., Tensor<1, 2>(), false)
                       .closest(Point<2>(1., 1.));
  BOOST_TEST(found.gap == -2.);
  BOOST_TEST(std::abs(found.normal.norm() - 1.) < 1e-15);
}



// The areas of the nodes sum up to the boundary, whatever it counts for.
BOOST_AUTO_TEST_CASE(contactor_areas)
{
  const std::string rectangle = "set Mesh = rectangle\nsubsection Rectangle\n"
                                " set Corners = 1, 0 ; 3, 1\n"
                                " set Cells = 3, 2\nend\nset Thickness = 0.5\n";
  for (const unsigned int degree : {1u, 2u, 3u})
    {
      const std::string section =
        rectangle + "set Element degree = " + std::to_string(degree) + "\n";
      const auto total = [&](const Formulation formulation) {
        const auto model = test_model<2>(section, formulation);
        const auto surface =
          contactor_surface(*model.parts()[0].body, "bottom");
        BOOST_TEST(surface.nodes.size() == 3 * degree + 1);
        BOOST_TEST(surface.faces.size() == 3 * degree);
        double length = 0.;
        for (const auto &face : surface.faces)
          length +=
            surface.nodes[face[0]].point.distance(surface.nodes[face[1]].point);
        BOOST_TEST(std::abs(length - 2.) < 1e-13);
        double sum = 0.;
        for (const double area : surface.areas)
          {
            BOOST_TEST(area > 0.);
            sum += area;
          }
        return sum;
      };
      BOOST_TEST(std::abs(total(Formulation::plane_strain) - 0.5 * 2.) < 1e-13);
      BOOST_TEST(std::abs(total(Formulation::axisymmetric) -
                          numbers::PI * (9. - 1.)) < 1e-12);
    }
  const auto model =
    test_model<3>("set Mesh = box\nsubsection Box\n"
                  " set Corners = 0, 0, 0 ; 2, 1, 1\n set Cells = 2, 2, 1\n"
                  "end\nset Element degree = 2\n",
                  Formulation::three_dimensional);
  const auto surface = contactor_surface(*model.parts()[0].body, "right");
  BOOST_TEST(surface.nodes.size() == 15u);
  BOOST_TEST(surface.faces.size() == 8u);
  double sum = 0.;
  for (const double area : surface.areas)
    sum += area;
  BOOST_TEST(std::abs(sum - 1.) < 1e-13);
}

// On the axis a quadratic element gives its corner no area, not a rounding
// error of it, and no pressure.
BOOST_AUTO_TEST_CASE(node_without_area)
{
  const auto model =
    test_model<2>("set Mesh = rectangle\nsubsection Rectangle\n"
                  " set Corners = 0, 0 ; 3, 1\n set Cells = 3, 2\nend\n"
                  "set Element degree = 2\n",
                  Formulation::axisymmetric);
  const auto   surface = contactor_surface(*model.parts()[0].body, "bottom");
  unsigned int on_axis = 0;
  for (unsigned int n = 0; n < surface.nodes.size(); ++n)
    if (surface.nodes[n].point[0] == 0.)
      {
        ++on_axis;
        BOOST_TEST(surface.areas[n] == 0.);
      }
    else
      BOOST_TEST(surface.areas[n] > 0.1);
  ContactPoint<2> point;
  BOOST_TEST(point.pressure(5.) == 0.);
  point.area = 2.;
  BOOST_TEST(point.pressure(5.) == 2.5);
  BOOST_TEST(on_axis == 1u);
}

BOOST_AUTO_TEST_SUITE_END()
