#include <signorini/input/input_error.h>

#include <boost/test/unit_test.hpp>

#include <random>

#include "contains.h"
#include "stored_run.h"

BOOST_AUTO_TEST_SUITE(displacement_history)

using namespace dealii;
using namespace Signorini;

namespace
{
  // A polynomial of this degree.
  template <int dim>
  double
  polynomial(const Point<dim>  &x,
             const unsigned int c,
             const unsigned int degree)
  {
    double sum = 0.3 + 0.1 * c;
    for (unsigned int d = 0; d < dim; ++d)
      sum += (c == d ? 1. : -0.4) * std::pow(x[d], degree) + 0.2 * x[d];
    return sum + (degree > 1 ? x[0] * x[dim - 1] : 0.);
  }

  template <int dim>
  Point<dim>
  random_point(std::mt19937 &generator)
  {
    std::uniform_real_distribution<> number(0.01, 0.99);
    Point<dim>                       p;
    for (unsigned int d = 0; d < dim; ++d)
      p[d] = number(generator);
    return p;
  }

  double
  largest_difference(const std::vector<double> &a, const std::vector<double> &b)
  {
    BOOST_REQUIRE(a.size() == b.size());
    double largest = 0.;
    for (unsigned int i = 0; i < a.size(); ++i)
      largest = std::max(largest, std::abs(a[i] - b[i]));
    return largest;
  }

  template <int dim>
  std::vector<double>
  flat(const std::vector<Tensor<1, dim>> &values)
  {
    std::vector<double> result;
    for (const auto &value : values)
      result.insert(result.end(), value.begin_raw(), value.end_raw());
    return result;
  }

  // The polynomial of the degree of the elements, anywhere in the unit square
  // or cube.
  template <int dim>
  void
  check_polynomial(const unsigned int degree, const std::string &mesh)
  {
    std::mt19937 generator(degree);
    const auto   body = test_body<dim>(
      "set Element degree = " + std::to_string(degree) + "\n" + mesh);
    const auto field = [&](const Point<dim> &x, const unsigned int c) {
      return polynomial(x, c, degree);
    };
    StoredRun<dim> run;
    run.store(*body, 0., at_nodes(*body, field));

    std::vector<Point<dim>> points;
    std::vector<double>     exact;
    for (unsigned int i = 0; i < 200; ++i)
      points.push_back(random_point<dim>(generator));
    for (const auto &node : body->nodes())
      points.push_back(node.point);
    for (const auto &point : points)
      for (unsigned int c = 0; c < dim; ++c)
        exact.push_back(field(point, c));
    BOOST_TEST(largest_difference(flat(run.history(points).values(0.)), exact) <
               1e-13);
  }

  // Whatever the displacement is: that of the element at the same place.
  template <int dim>
  void
  check_element(const std::string &section)
  {
    std::mt19937                     generator(7);
    std::uniform_real_distribution<> number(-1., 1.);
    const auto                       body = test_body<dim>(section);
    const Vector<double>             u =
      at_nodes(*body, [&](const Point<dim> &, unsigned int) {
        return number(generator);
      });
    StoredRun<dim> run;
    run.store(*body, 0., u);

    std::vector<Point<dim>>              points;
    std::vector<double>                  exact;
    std::vector<types::global_dof_index> dofs(body->fe().n_dofs_per_cell());
    for (const auto &cell : body->dof_handler().active_cell_iterators())
      {
        const Point<dim> unit_point = random_point<dim>(generator);
        points.push_back(
          body->mapping().transform_unit_to_real_cell(cell, unit_point));
        cell->get_dof_indices(dofs);
        std::vector<double> sum(dim, 0.);
        for (unsigned int i = 0; i < dofs.size(); ++i)
          sum[body->fe().system_to_component_index(i).first] +=
            u[dofs[i]] * body->fe().shape_value(i, unit_point);
        exact.insert(exact.end(), sum.begin(), sum.end());
      }
    BOOST_TEST(largest_difference(flat(run.history(points).values(0.)), exact) <
                 1e-12,
               section);
  }

  template <int dim>
  std::string
  error_at(const StoredRun<dim> &run, const Point<dim> &point)
  {
    try
      {
        run.history({point});
      }
    catch (const InputError &error)
      {
        return error.what();
      }
    return "";
  }

  // One cell; the displacement of all its nodes is (u, 0).
  struct Motion
  {
    Motion()
      : body(test_body<2>(""))
    {}

    void
    store(const double time, const double u)
    {
      run.store(*body,
                time,
                at_nodes(*body, [u](const Point<2> &, const unsigned int c) {
                  return c == 0 ? u : 0.;
                }));
    }

    double
    at(const double            time,
       const TimeInterpolation interpolation,
       const unsigned int      derivative = 0) const
    {
      return run.history({Point<2>(0., 1.)}, interpolation)
        .values(time, derivative)[0][0];
    }

    std::unique_ptr<Body<2>> body;
    StoredRun<2>             run;
  };

  const auto linear = TimeInterpolation::linear;
  const auto cubic  = TimeInterpolation::cubic;
} // namespace



BOOST_AUTO_TEST_CASE(polynomials)
{
  const std::string hanging =
    "set Refinements near = 0.3, 0.2 : 0.1 : 2 ; 0.8, 0.9 : 0.05 : 1\n"
    "subsection Rectangle\n set Cells = 4, 3\nend\n";
  const std::string box = "set Refinements near = 0.3, 0.2, 0.1 : 0.1 : 1\n"
                          "subsection Box\n set Cells = 3, 2, 2\nend\n";
  for (unsigned int degree = 1; degree <= 4; ++degree)
    check_polynomial<2>(degree, hanging);
  for (unsigned int degree = 1; degree <= 3; ++degree)
    check_polynomial<3>(degree, box);
}

BOOST_AUTO_TEST_CASE(elements)
{
  for (unsigned int degree = 1; degree <= 3; ++degree)
    {
      const std::string lines =
        "set Element degree = " + std::to_string(degree) + "\n";
      check_element<2>(lines + "set Mesh = ring\nsubsection Ring\n"
                               " set Cells = 12, 3\nend\n");
      check_element<2>(lines + "set Mesh = disc\n");
      check_element<2>(lines + "set Mesh = pinion\n");
      if (degree < 3)
        check_element<3>(lines + "set Mesh = ball\n");
    }
}

BOOST_AUTO_TEST_CASE(beyond_the_facets)
{
  // Eight cells around: the sagitta is 1 - cos(22.5 degrees) = 0.076 of the
  // outer radius. Linear functions go on as they are.
  const auto   ring = test_body<2>("set Mesh = ring\nsubsection Ring\n"
                                   " set Cells = 8, 1\nend\n");
  StoredRun<2> run;
  run.store(*ring, 0., at_nodes(*ring, [](const Point<2> &x, unsigned int c) {
    return polynomial(x, c, 1);
  }));
  std::vector<Point<2>> points;
  std::vector<double>   exact;
  for (unsigned int i = 0; i < 100; ++i)
    {
      const double angle = 0.01 + 2. * numbers::PI * i / 100.;
      points.emplace_back(std::cos(angle), std::sin(angle));
      for (unsigned int c = 0; c < 2; ++c)
        exact.push_back(polynomial(points.back(), c, 1));
    }
  BOOST_TEST(largest_difference(flat(run.history(points).values(0.)), exact) <
             1e-13);

  // A square: up to 0.2 of its size.
  const auto   square = test_body<2>("");
  StoredRun<2> one;
  one.store(*square,
            0.,
            at_nodes(*square,
                     [](const Point<2> &x, unsigned int c) { return x[c]; }));
  const auto u = one.history({Point<2>(1.19, 0.5)}).values(0.);
  BOOST_TEST((u[0] - Tensor<1, 2>({1.19, 0.5})).norm() < 1e-13);
  const std::string error = error_at(one, Point<2>(1.21, 0.75));
  BOOST_TEST(contains(error,
                      "The point (1.21 0.75) lies outside of body \"b\""),
             error);
  BOOST_TEST(contains(error, one.folder.path.string()), error);
  BOOST_TEST(contains(error, "nearest node is at (1 1)"), error);
  BOOST_TEST(error_at(one, Point<2>(9., 9.)) != "");

  // A flat cell: as far from it, but its functions go on by 0.2 of its height.
  const auto strip =
    test_body<2>("subsection Rectangle\n set Corners = 0, 0 ; 1, 0.01\n"
                 "end\n");
  StoredRun<2> thin;
  thin.store(*strip,
             0.,
             at_nodes(*strip,
                      [](const Point<2> &x, unsigned int c) { return x[c]; }));
  const auto v = thin.history({Point<2>(0.5, 0.1)}).values(0.);
  BOOST_TEST((v[0] - Tensor<1, 2>({0.5, 0.012})).norm() < 1e-13);
}

BOOST_AUTO_TEST_CASE(static_times)
{
  Motion motion;
  motion.store(1., 3.);
  BOOST_TEST(motion.at(1., linear) == 3.);
  BOOST_TEST(motion.at(1., cubic) == 3.);
  BOOST_TEST(motion.at(1., cubic, 1) == 0.);
  motion.store(2., 5.1);
  motion.store(6., -0.7);
  BOOST_TEST(motion.at(1., linear) == 3.);
  BOOST_TEST(motion.at(2., linear) == 5.1);
  BOOST_TEST(motion.at(6., linear) == -0.7);
  BOOST_TEST(std::abs(motion.at(1.25, linear) - 3.525) < 1e-14);
  BOOST_TEST(std::abs(motion.at(5., linear) - 0.75) < 1e-14);
  BOOST_TEST(std::abs(motion.at(5., linear, 1) + 1.45) < 1e-14);
  BOOST_TEST(std::abs(motion.at(2., linear, 1) - (2.1 - 1.45) / 2.) < 1e-14);
  BOOST_TEST(motion.at(5., linear, 2) == 0.);
  BOOST_TEST(motion.run.history({}).times() ==
               (std::vector<double>{1., 2., 6.}),
             boost::test_tools::per_element());

  // The same time again: the last one counts.
  motion.store(6., 4.);
  BOOST_TEST(motion.at(6., linear) == 4.);
}

BOOST_AUTO_TEST_CASE(dynamic_times)
{
  Motion                    motion, sine;
  const std::vector<double> times = {0.1, 0.3, 0.35, 0.6, 1.};
  const auto u = [](const double t) { return 2. - t + 3. * t * t; };
  for (const double t : times)
    {
      motion.store(t, u(t));
      sine.store(t, std::sin(9. * t));
    }
  for (const double t : times)
    BOOST_TEST(sine.at(t, cubic) == std::sin(9. * t));
  for (double t = 0.1; t < 1.; t += 0.03)
    {
      BOOST_TEST(std::abs(motion.at(t, cubic) - u(t)) < 1e-13);
      BOOST_TEST(std::abs(motion.at(t, cubic, 1) - (6. * t - 1.)) < 1e-12);
      BOOST_TEST(std::abs(motion.at(t, cubic, 2) - 6.) < 1e-10);

      // Derivatives of any motion are those of its displacements.
      const double h = 1e-5;
      if (t < 0.11)
        continue;
      const double before = sine.at(t - h, cubic), now = sine.at(t, cubic),
                   after = sine.at(t + h, cubic);
      BOOST_TEST(std::abs((after - before) / (2. * h) - sine.at(t, cubic, 1)) <
                 1e-6);
      BOOST_TEST(std::abs((after - 2. * now + before) / (h * h) -
                          sine.at(t, cubic, 2)) < 1e-3);
    }
  // The velocity is continuous.
  for (const double t : {0.3, 0.35, 0.6})
    BOOST_TEST(std::abs(sine.at(t + 1e-7, cubic, 1) -
                        sine.at(t - 1e-7, cubic, 1)) < 1e-4);

  // The acceleration of t^3 jumps from 6 h to -6 h.
  Motion cube;
  for (int i = -3; i <= 3; ++i)
    cube.store(0.1 * i, std::pow(0.1 * i, 3));
  BOOST_TEST(std::abs(cube.at(1e-7, cubic, 2) + 0.6) < 1e-4);
  BOOST_TEST(std::abs(cube.at(-1e-7, cubic, 2) - 0.6) < 1e-4);
  BOOST_TEST(std::abs(cube.at(0., cubic, 2)) < 1e-10);

  // Two times: a straight line.
  Motion two;
  two.store(0., 1.);
  two.store(2., 5.);
  BOOST_TEST(std::abs(two.at(0.5, cubic) - 2.) < 1e-15);
  BOOST_TEST(std::abs(two.at(0.5, cubic, 1) - 2.) < 1e-15);
}

BOOST_AUTO_TEST_CASE(any_order_of_times)
{
  // More times than are kept.
  Motion motion;
  for (unsigned int i = 0; i < 30; ++i)
    motion.store(i, i * i);
  const auto   history = motion.run.history({Point<2>(0.5, 0.5)}, cubic);
  std::mt19937 generator(3);
  std::uniform_real_distribution<> number(0., 29.);
  for (unsigned int i = 0; i < 100; ++i)
    {
      const double t = number(generator);
      BOOST_TEST(std::abs(history.values(t)[0][0] - t * t) < 1e-11);
    }
}

BOOST_AUTO_TEST_CASE(times_out_of_range)
{
  Motion motion;
  motion.store(0.1, 1.);
  motion.store(0.3, 2.);
  for (const double t : {0., 0.0999999, 0.3000001, 1., std::nan("")})
    try
      {
        motion.at(t, linear);
        BOOST_ERROR("nothing was thrown");
      }
    catch (const InputError &error)
      {
        BOOST_TEST(contains(error.what(), "the displacement of body \"b\""),
                   error.what());
        BOOST_TEST(contains(error.what(), "from 0.1 to 0.3 s"), error.what());
        BOOST_TEST(contains(error.what(), motion.run.folder.path.string()));
      }
  // Rounding errors do not matter.
  BOOST_TEST(motion.at(0.1 + 0.2, linear) == 2.);
  BOOST_TEST(motion.at(0.1 - 1e-12, cubic) == 1.);
}

BOOST_AUTO_TEST_CASE(the_mesh_changes)
{
  const auto coarse = test_body<2>("");
  const auto fine   = test_body<2>("set Global refinements = 2\n");
  const auto field  = [](const Point<2> &x, const unsigned int c) {
    return polynomial(x, c, 1);
  };
  StoredRun<2>   run;
  Vector<double> u = at_nodes(*coarse, field);
  run.store(*coarse, 0., u);
  u *= 2.;
  run.store(*coarse, 1., u);
  u = at_nodes(*fine, field);
  u *= 3.;
  run.store(*fine, 2., u);
  const Point<2> p(0.3, 0.4);
  const auto     history = run.history({p});
  for (const double t : {0., 0.5, 1., 1.75, 2.})
    for (unsigned int c = 0; c < 2; ++c)
      BOOST_TEST(std::abs(history.values(t)[0][c] -
                          (1. + t) * polynomial(p, c, 1)) < 1e-14);
}

BOOST_AUTO_TEST_SUITE_END()
