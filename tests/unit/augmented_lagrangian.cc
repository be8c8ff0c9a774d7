#include <signorini/input/input_error.h>
#include <signorini/variational_inequality/augmented_lagrangian.h>
#include <signorini/variational_inequality/interface_error.h>
#include <signorini/variational_inequality/quadratic_programme.h>
#include <signorini/variational_inequality/semismooth_newton.h>

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <random>

#include "friction_reference.h"

BOOST_AUTO_TEST_SUITE(augmented_lagrangian)

using namespace Signorini;

namespace
{
  constexpr double       gap        = 5e-5;
  constexpr unsigned int n_contacts = 25;

  InterfaceProblem
  springs()
  {
    return InterfaceReference::make_problem(
      InterfaceReference::springs_over_floor(n_contacts, gap));
  }
} // namespace



BOOST_AUTO_TEST_CASE(equals_the_quadratic_programme)
{
  const InterfaceProblem  problem = springs();
  const InterfaceSolution exact   = QuadraticProgramme().solve(problem, {});
  double                  largest_force = 0.;
  for (const double force : exact.forces.normal)
    largest_force = std::max(largest_force, force);
  BOOST_REQUIRE(largest_force > 0.);

  // Nodal stiffnesses are 4e5 to 7e8 N/m.
  for (const double stiffness : {1e6, 1e8, 1e10})
    for (const double tolerance : {1e-9, 1e-13})
      BOOST_TEST_CONTEXT("K_N " << stiffness << ", tolerance " << tolerance)
      {
        const AugmentedLagrangian algorithm(stiffness, tolerance, 100000);
        const InterfaceSolution   found = algorithm.solve(problem, {});
        for (unsigned int k = 0; k < n_contacts; ++k)
          {
            const double left = problem.gap_after(k, found.displacement);
            BOOST_TEST(left >= -tolerance);
            if (found.forces.normal[k] > 0.)
              BOOST_TEST(left <= tolerance);
            BOOST_TEST(found.forces.normal[k] >= 0.);
          }
        // (du - du_exact) S (du - du_exact) <= sum of forces times gaps left.
        for (unsigned int i = 0; i < problem.size(); ++i)
          BOOST_TEST(std::abs(found.displacement(i) - exact.displacement(i)) <=
                     std::max(10. * tolerance, 1e-12 * gap) + 1e-6 * gap);
        if (tolerance < 1e-12)
          for (unsigned int k = 0; k < n_contacts; ++k)
            BOOST_TEST(
              std::abs(found.forces.normal[k] - exact.forces.normal[k]) <=
              1e-5 * largest_force);

        // From its own forces it is there at once.
        BOOST_TEST(algorithm.solve(problem, found.forces).n_iterations == 1);
      }
}



BOOST_AUTO_TEST_CASE(one_node_by_hand)
{
  // S = 3, r = -6, gap 1, K = 3: lambda = 3/2, then half the error each time.
  InterfaceReference::Data data{dealii::FullMatrix<double>(1, 1),
                                dealii::Vector<double>(1),
                                {{{{0, -1.}}, 1.}}};
  data.stiffness(0, 0)           = 3.;
  data.force(0)                  = -6.;
  const InterfaceProblem problem = InterfaceReference::make_problem(data);
  // The penetration after j updates is 2^-j.
  const InterfaceSolution solution =
    AugmentedLagrangian(3., 1.01 / 64., 100).solve(problem, {});
  BOOST_TEST(solution.n_iterations == 6);
  BOOST_TEST(std::abs(solution.forces.normal[0] - 3. * (1. - 1. / 64.)) <=
             1e-14);
  BOOST_TEST(std::abs(problem.gap_after(0, solution.displacement) + 1. / 64.) <=
             1e-14);
}



BOOST_AUTO_TEST_CASE(friction_agrees_with_newton)
{
  // Weak friction, so that there is one solution only.
  std::mt19937 generator(41);
  for (unsigned int trial = 0; trial < 30; ++trial)
    BOOST_TEST_CONTEXT("trial " << trial)
    {
      const unsigned int m    = 1 + trial % 4;
      auto               data = FrictionReference::random_spatial_problem(
        m, m, /*at_one_node=*/false, generator);
      for (InterfaceContact &contact : data.contacts)
        contact.friction_coefficient *= 0.2;
      const InterfaceProblem  problem  = InterfaceReference::make_problem(data);
      const InterfaceSolution expected = SemismoothNewton().solve(problem, {});
      const AugmentedLagrangian algorithm(20., 1e-11, 100000, 10.);
      const InterfaceSolution   found = algorithm.solve(problem, {});
      for (unsigned int i = 0; i < 3 * m; ++i)
        BOOST_TEST(std::abs(found.displacement(i) - expected.displacement(i)) <=
                   1e-7);
      for (unsigned int k = 0; k < m; ++k)
        for (unsigned int j = 0; j < 2; ++j)
          BOOST_TEST(std::abs(found.forces.tangential[k][j] -
                              expected.forces.tangential[k][j]) <= 1e-6);
    }
}



BOOST_AUTO_TEST_CASE(never_stops_silently)
{
  const InterfaceProblem problem = springs();
  try
    {
      AugmentedLagrangian(1e6, 1e-13, 3).solve(problem, {});
      BOOST_ERROR("accepted without converging");
    }
  catch (const InterfaceError &error)
    {
      BOOST_TEST(!error.contacts().empty());
      BOOST_TEST(std::string(error.what()).find("after 3 iterations") !=
                 std::string::npos);
    }
  BOOST_CHECK_THROW(AugmentedLagrangian(0., 1e-9, 10), InputError);
  BOOST_CHECK_THROW(AugmentedLagrangian(1., 0., 10), InputError);
  BOOST_CHECK_THROW(AugmentedLagrangian(1., 1e-9, 0), InputError);
}

BOOST_AUTO_TEST_SUITE_END()
