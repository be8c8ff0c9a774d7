#include <signorini/variational_inequality/ando.h>
#include <signorini/variational_inequality/interface_error.h>
#include <signorini/variational_inequality/kkt_residual.h>
#include <signorini/variational_inequality/quadratic_programme.h>
#include <signorini/variational_inequality/semismooth_newton.h>

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <random>

#include "friction_reference.h"

BOOST_AUTO_TEST_SUITE(semismooth_newton)

using namespace Signorini;
using dealii::Vector;

BOOST_AUTO_TEST_CASE(three_dimensions)
{
  // With one contact at a node there is always a solution.
  std::mt19937           generator(11);
  const SemismoothNewton algorithm;
  unsigned int           n_stuck = 0, n_slipping = 0, n_fallbacks = 0;
  double                 worst = 0.;
  for (unsigned int trial = 0; trial < 400; ++trial)
    BOOST_TEST_CONTEXT("trial " << trial)
    {
      const unsigned int m    = 1 + trial % 10;
      const auto         data = FrictionReference::random_spatial_problem(
        m, m, /*at_one_node=*/false, generator);
      const InterfaceProblem  problem  = InterfaceReference::make_problem(data);
      const InterfaceSolution solution = algorithm.solve(problem, {});
      const double            residual = kkt_residual(problem, solution).norm();
      worst                            = std::max(worst, residual);
      BOOST_TEST(residual <= 1e-12);
      n_fallbacks += solution.n_fallbacks;
      BOOST_TEST((solution.n_fallbacks > 0) ==
                 !solution.fallback_contacts.empty());
      bool closed = false;
      for (unsigned int k = 0; k < m; ++k)
        {
          if (!(solution.forces.normal[k] > 0.))
            continue;
          closed = true;
          const double slip =
            std::hypot(problem.slip_after(k, 0, solution.displacement),
                       problem.slip_after(k, 1, solution.displacement));
          ++(slip > 1e-9 ? n_slipping : n_stuck);
        }
      // From its own forces.
      BOOST_TEST(algorithm.solve(problem, solution.forces).n_iterations ==
                 (closed ? 1U : 0U));
    }
  BOOST_TEST_MESSAGE("stuck " << n_stuck << ", slipping " << n_slipping
                              << ", fallbacks " << n_fallbacks
                              << ", KKT residual " << worst);
  BOOST_TEST(n_stuck > 200);
  BOOST_TEST(n_slipping > 200);
  BOOST_TEST(n_fallbacks < 10);
}



BOOST_AUTO_TEST_CASE(jammed_in_three_dimensions)
{
  // Two contacts at one node may jam. Then an error names contacts; what is
  // returned is a solution.
  std::mt19937 generator(12);
  unsigned int n_jammed = 0;
  for (unsigned int trial = 0; trial < 100; ++trial)
    BOOST_TEST_CONTEXT("trial " << trial)
    {
      const unsigned int m    = 2 + trial % 5;
      const auto         data = FrictionReference::random_spatial_problem(
        std::max(1U, m / 2), m, /*at_one_node=*/true, generator);
      const InterfaceProblem problem = InterfaceReference::make_problem(data);
      try
        {
          const InterfaceSolution solution =
            SemismoothNewton().solve(problem, {});
          BOOST_TEST(kkt_residual(problem, solution).norm() <= 1e-9);
        }
      catch (const InterfaceError &error)
        {
          ++n_jammed;
          BOOST_TEST(!error.contacts().empty());
          BOOST_TEST(std::string(error.what()).find("Contacts: ") !=
                     std::string::npos);
        }
    }
  BOOST_TEST_MESSAGE("jammed " << n_jammed);
  BOOST_TEST(n_jammed < 50);
}



BOOST_AUTO_TEST_CASE(two_tangents_agree_with_one)
{
  // The same problem in the plane, with a second tangent across it that
  // nothing pushes along.
  std::mt19937 generator(13);
  for (unsigned int trial = 0; trial < 50; ++trial)
    BOOST_TEST_CONTEXT("trial " << trial)
    {
      const unsigned int m    = 1 + trial % 4;
      auto               data = FrictionReference::random_spatial_problem(
        m, m, /*at_one_node=*/false, generator);
      for (unsigned int k = 0; k < m; ++k)
        {
          // Weak friction, so that there is one solution only.
          data.contacts[k].friction_coefficient *= 0.1;
          for (unsigned int i = 0; i < 3; ++i)
            {
              data.force(3 * k + i) = i < 2 ? data.force(3 * k + i) : 0.;
              for (unsigned int j = 0; j < 3 * m; ++j)
                if ((i == 2) != (j % 3 == 2))
                  data.stiffness(3 * k + i, j) = data.stiffness(j, 3 * k + i) =
                    0.;
            }
          const double phi = 0.7 * trial + k;
          const double c = std::cos(phi), s = std::sin(phi);
          data.contacts[k].normal   = {{3 * k, c}, {3 * k + 1, s}};
          data.contacts[k].tangents = {{{3 * k, -s}, {3 * k + 1, c}},
                                       {{3 * k + 2, 1.}}};
          data.contacts[k].slip[1]  = 0.;
        }
      const InterfaceProblem  spatial = InterfaceReference::make_problem(data);
      const InterfaceSolution found   = SemismoothNewton().solve(spatial, {});
      for (InterfaceContact &contact : data.contacts)
        contact.tangents.resize(1);
      const InterfaceProblem  plane    = InterfaceReference::make_problem(data);
      const InterfaceSolution expected = Ando().solve(plane, {});
      for (unsigned int i = 0; i < 3 * m; ++i)
        BOOST_TEST(std::abs(found.displacement(i) - expected.displacement(i)) <=
                   1e-10);
    }
}



BOOST_AUTO_TEST_CASE(without_friction_the_quadratic_programme)
{
  const auto data = InterfaceReference::springs_over_floor(40, 5e-5);
  const InterfaceProblem  problem  = InterfaceReference::make_problem(data);
  const InterfaceSolution expected = QuadraticProgramme().solve(problem, {});
  const InterfaceSolution found    = SemismoothNewton().solve(problem, {});
  BOOST_TEST((found.displacement == expected.displacement));
  BOOST_TEST(found.forces.normal == expected.forces.normal,
             boost::test_tools::per_element());
  BOOST_TEST(found.n_iterations == expected.n_iterations);
}

BOOST_AUTO_TEST_SUITE_END()
