#include <signorini/solid/error_estimate.h>

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <numeric>

#include "test_body.h"

BOOST_AUTO_TEST_SUITE(error_estimate)

using namespace Signorini;

namespace
{
  // u_x = f(x) at the nodes of the body.
  template <typename Function>
  dealii::Vector<double>
  stretched(const SolidModel<2> &model, const Function &f)
  {
    dealii::Vector<double> u(model.n_dofs());
    for (const auto &node : model.parts()[0].body->nodes())
      u[node.dofs[0]] = f(node.point[0]);
    return u;
  }

  SolidModel<2>
  strip(const unsigned int n_cells)
  {
    return test_bodies<2>({"set Mesh = rectangle\n"
                           "subsection Rectangle\n"
                           " set Corners = 0, 0 ; 4, 1\n"
                           " set Cells = " +
                           std::to_string(4 * n_cells) + ", " +
                           std::to_string(n_cells) +
                           "\nend\n"
                           "set Thickness = 0.5\n"
                           "subsection Material\n"
                           " set Young's modulus = 10\n"
                           " set Poisson's ratio = 0.25\n"
                           "end\n"},
                          Formulation::plane_strain);
  }
} // namespace



// M = E (1 - nu)/((1 + nu)(1 - 2 nu)) = 12 Pa. Squares of size h that follow
// u = x^2: at each vertical edge the slope jumps by 2 h.
BOOST_AUTO_TEST_CASE(jumps_of_slopes)
{
  for (const unsigned int n : {1, 2, 4})
    {
      const auto   model = strip(n);
      const auto   u = stretched(model, [](const double x) { return x * x; });
      const double h = 1. / n;
      const double edge = 12. * std::sqrt(2.) * h / 24. * 4. * h * h * h * 0.5;
      const auto  &body = *model.parts()[0].body;
      const auto   eta  = estimated_errors(body, u);
      for (const auto &cell : body.dof_handler().active_cell_iterators())
        {
          unsigned int n_edges = 0;
          for (const auto &face : cell->face_iterators())
            n_edges += !face->at_boundary() &&
                       std::abs(face->center()[0] - cell->center()[0]) > h / 4.;
          BOOST_TEST(eta[cell->active_cell_index()] == n_edges * edge,
                     boost::test_tools::tolerance(1e-5));
        }
    }
}

BOOST_AUTO_TEST_CASE(linear_displacement_has_no_error)
{
  const auto model = strip(2);
  const auto eta =
    estimated_errors(*model.parts()[0].body,
                     stretched(model, [](const double x) { return 3. * x; }));
  BOOST_TEST(std::accumulate(eta.begin(), eta.end(), 0.) < 1e-12);
}

BOOST_AUTO_TEST_SUITE_END()
