#include <signorini/variational_inequality/interface_error.h>
#include <signorini/variational_inequality/kkt_residual.h>
#include <signorini/variational_inequality/quadratic_programme.h>

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <random>

#include "interface_reference.h"

BOOST_AUTO_TEST_SUITE(quadratic_programme)

using namespace Signorini;
using dealii::Vector;

namespace
{
  // The same problem where a metre reads `length' and a newton `force'.
  InterfaceReference::Data
  in_units(InterfaceReference::Data data,
           const double             length,
           const double             force)
  {
    data.stiffness *= force / length;
    data.force *= force;
    for (InterfaceContact &contact : data.contacts)
      contact.gap *= length;
    return data;
  }

  unsigned int
  n_closed(const InterfaceSolution &solution)
  {
    return std::count_if(solution.forces.normal.begin(),
                         solution.forces.normal.end(),
                         [](const double force) { return force > 0.; });
  }
} // namespace



BOOST_AUTO_TEST_CASE(equals_brute_force)
{
  std::mt19937             generator(99);
  const QuadraticProgramme algorithm;
  unsigned int             n_infeasible = 0, n_open = 0;
  double                   worst_difference = 0., worst_residual = 0.;
  for (unsigned int trial = 0; trial < 600; ++trial)
    {
      const unsigned int n = 2 + trial % 5, m = 1 + trial % 7;
      const auto data = InterfaceReference::random_problem(n, m, generator);
      const InterfaceProblem problem  = InterfaceReference::make_problem(data);
      const auto             expected = InterfaceReference::brute_force(data);
      std::vector<double>    start;
      if (trial % 2 == 1)
        for (unsigned int k = 0; k < m; ++k)
          start.push_back(k % 3 * 2.);
      BOOST_TEST_CONTEXT("trial " << trial)
      {
        if (!expected)
          {
            ++n_infeasible;
            try
              {
                algorithm.solve(problem, InterfaceForces(start));
                BOOST_ERROR("a contradiction was accepted");
              }
            catch (const InterfaceError &error)
              {
                BOOST_TEST(!error.contacts().empty());
              }
            continue;
          }
        const InterfaceSolution found =
          algorithm.solve(problem, InterfaceForces(start));
        n_open += n_closed(found) == 0;
        Vector<double> difference = found.displacement;
        difference -= *expected;
        const double error = difference.linfty_norm() /
                             (1. + problem.free_displacement().linfty_norm());
        const double residual = kkt_residual(problem, found).norm();
        worst_difference      = std::max(worst_difference, error);
        worst_residual        = std::max(worst_residual, residual);
        BOOST_TEST(error <= 1e-11);
        BOOST_TEST(residual <= 1e-12);
        for (const double force : found.forces.normal)
          BOOST_TEST(force >= 0.);
      }
    }
  BOOST_TEST_MESSAGE("infeasible " << n_infeasible << ", open " << n_open
                                   << ", difference " << worst_difference
                                   << ", KKT residual " << worst_residual);
  BOOST_TEST(n_infeasible > 10);
  BOOST_TEST(n_infeasible < 400);
  BOOST_TEST(n_open > 5);
}



BOOST_AUTO_TEST_CASE(all_open_needs_no_iteration)
{
  const auto       data    = InterfaceReference::springs_over_floor(20, 5e-5);
  InterfaceProblem problem = InterfaceReference::make_problem(data);
  for (unsigned int k = 0; k < 20; ++k)
    problem.set_gap(k, 1.);
  const InterfaceSolution solution =
    QuadraticProgramme().solve(problem,
                               InterfaceForces(std::vector<double>(20, 3.)));
  BOOST_TEST(solution.n_iterations == 0);
  BOOST_TEST(n_closed(solution) == 0);
  for (unsigned int k = 0; k < 20; ++k)
    BOOST_TEST(!problem.knows_response(k));
}



BOOST_AUTO_TEST_CASE(closed_gaps_vanish_to_rounding)
{
  const double           gap  = 5e-5;
  const auto             data = InterfaceReference::springs_over_floor(81, gap);
  const InterfaceProblem problem = InterfaceReference::make_problem(data);
  const QuadraticProgramme algorithm;
  const InterfaceSolution  solution = algorithm.solve(problem, {});
  BOOST_TEST(n_closed(solution) > 5);
  BOOST_TEST(n_closed(solution) < 76);
  double worst = 0.;
  for (unsigned int k = 0; k < 81; ++k)
    {
      const double left = problem.gap_after(k, solution.displacement);
      worst             = std::max(worst, -left);
      if (solution.forces.normal[k] > 0.)
        worst = std::max(worst, left);
    }
  BOOST_TEST_MESSAGE("closed " << n_closed(solution) << ", iterations "
                               << solution.n_iterations << ", |gap| / scale "
                               << worst / gap);
  BOOST_TEST(worst <= 1e-14 * gap);
  BOOST_TEST(kkt_residual(problem, solution).norm() <= 1e-11);
  BOOST_TEST(solution.n_iterations <= 20);

  // From its own forces: one face, and few responses.
  const InterfaceProblem  fresh = InterfaceReference::make_problem(data);
  const InterfaceSolution again = algorithm.solve(fresh, solution.forces);
  BOOST_TEST(again.n_iterations == 1);
  for (unsigned int k = 0; k < 81; ++k)
    {
      BOOST_TEST(fresh.knows_response(k) == (solution.forces.normal[k] > 0.));
      BOOST_TEST(std::abs(again.forces.normal[k] - solution.forces.normal[k]) <=
                 1e-9 * kkt_residual(problem, solution).force_scale);
    }
}



BOOST_AUTO_TEST_CASE(independent_of_units)
{
  // m-kg-s and mm-t-s (N), and two that nobody uses.
  std::mt19937             generator(17);
  const QuadraticProgramme algorithm;
  for (unsigned int trial = 0; trial < 20; ++trial)
    {
      auto data = InterfaceReference::springs_over_floor(30, 5e-5);
      std::uniform_real_distribution<double> factor(0.5, 1.5);
      for (double &force : data.force)
        force *= factor(generator);
      const InterfaceProblem  problem  = InterfaceReference::make_problem(data);
      const InterfaceSolution solution = algorithm.solve(problem, {});
      BOOST_REQUIRE(n_closed(solution) > 0);
      for (const auto &[length, force] :
           {std::pair(1e3, 1.), std::pair(1e-9, 3e6), std::pair(7e8, 1e-12)})
        {
          const InterfaceProblem other_problem =
            InterfaceReference::make_problem(in_units(data, length, force));
          const InterfaceSolution other = algorithm.solve(other_problem, {});
          BOOST_TEST(other.n_iterations == solution.n_iterations);
          const double force_scale =
            kkt_residual(problem, solution).force_scale;
          for (unsigned int k = 0; k < 30; ++k)
            {
              BOOST_TEST((other.forces.normal[k] > 0.) ==
                         (solution.forces.normal[k] > 0.));
              BOOST_TEST(std::abs(other.forces.normal[k] / force -
                                  solution.forces.normal[k]) <=
                         1e-9 * force_scale);
            }
          for (unsigned int i = 0; i < 60; ++i)
            BOOST_TEST(std::abs(other.displacement(i) / length -
                                solution.displacement(i)) <= 1e-9 * 5e-5);
        }
    }
}



BOOST_AUTO_TEST_CASE(not_a_number_is_refused)
{
  auto data     = InterfaceReference::springs_over_floor(5, 1.);
  data.force(3) = std::numeric_limits<double>::quiet_NaN();
  BOOST_CHECK_THROW(
    QuadraticProgramme().solve(InterfaceReference::make_problem(data), {}),
    InterfaceError);
}

BOOST_AUTO_TEST_SUITE_END()
