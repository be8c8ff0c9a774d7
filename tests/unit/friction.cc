#include <signorini/input/input_error.h>
#include <signorini/variational_inequality/ando.h>
#include <signorini/variational_inequality/interface_error.h>
#include <signorini/variational_inequality/kkt_residual.h>
#include <signorini/variational_inequality/quadratic_programme.h>
#include <signorini/variational_inequality/semismooth_newton.h>
#include <signorini/variational_inequality/two_step.h>

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <memory>
#include <random>

#include "friction_reference.h"

BOOST_AUTO_TEST_SUITE(friction)

// What holds for every algorithm that obeys Coulomb's law.
using namespace Signorini;
using dealii::Vector;

namespace
{
  AlternationControl
  fine()
  {
    AlternationControl control;
    control.force_tolerance = 1e-10;
    return control;
  }

  // Each with what its forces may be off by, relative to the problem.
  struct Exact
  {
    std::unique_ptr<InterfaceAlgorithm> algorithm;
    double                              displacement_tolerance;
    double                              residual_tolerance;
  };

  std::vector<Exact>
  exact_algorithms()
  {
    std::vector<Exact> list;
    list.push_back({std::make_unique<SemismoothNewton>(), 1e-10, 1e-11});
    list.push_back({std::make_unique<Ando>(), 1e-10, 1e-11});
    // To its epsilon: forces of the order of one over stiffnesses of 0.3.
    list.push_back({std::make_unique<TwoStep>(fine()), 2e-7, 1e-8});
    return list;
  }

  InterfaceForces
  some_forces(const unsigned int m, const unsigned int trial)
  {
    if (trial % 2 == 0)
      return {};
    InterfaceForces forces(m);
    for (unsigned int k = 0; k < m; ++k)
      {
        forces.normal[k]        = (k + trial) % 3;
        forces.tangential[k][0] = (k % 2 == 0 ? 0.3 : -0.3) * forces.normal[k];
      }
    return forces;
  }

  // Compares with all solutions that there are.
  struct RandomComparison
  {
    void
    run(const unsigned int n_nodes,
        const unsigned int m,
        const unsigned int trial,
        std::mt19937      &generator)
    {
      const auto data =
        FrictionReference::random_problem(n_nodes, m, generator);
      const auto solutions = FrictionReference::StateSearch(data).run();
      const InterfaceProblem problem = InterfaceReference::make_problem(data);
      ++(solutions.empty()     ? n_without :
         solutions.size() == 1 ? n_unique :
                                 n_several);
      for (const Exact &exact : exact_algorithms())
        BOOST_TEST_CONTEXT("trial " << trial << ", " << exact.algorithm->name())
        {
          try
            {
              const InterfaceSolution found =
                exact.algorithm->solve(problem, some_forces(m, trial));
              n_fallbacks += found.n_fallbacks;
              const double residual = kkt_residual(problem, found).norm();
              BOOST_TEST(residual <= exact.residual_tolerance);
              if (solutions.size() == 1)
                for (unsigned int i = 0; i < 2 * n_nodes; ++i)
                  BOOST_TEST(
                    std::abs(found.displacement(i) - solutions[0][i]) <=
                    exact.displacement_tolerance);
            }
          catch (const InterfaceError &error)
            {
              BOOST_TEST(solutions.empty(), error.what());
              BOOST_TEST(!error.contacts().empty());
            }
        }
    }

    unsigned int n_unique = 0, n_several = 0, n_without = 0, n_fallbacks = 0;
  };

  // One node of stiffness S = 3 N/m in x and y, pressed onto a floor at y = -1
  // with 6 N, pulled by @p pull along it.
  InterfaceReference::Data
  block(const double pull, const double mu)
  {
    InterfaceReference::Data data{dealii::FullMatrix<double>(2, 2),
                                  Vector<double>(2),
                                  {{{{1, -1.}}, 1., {{{0, 1.}}}}}};
    data.stiffness(0, 0) = data.stiffness(1, 1) = 3.;
    data.force(0)                               = pull;
    data.force(1)                               = -6.;
    data.contacts[0].friction_coefficient       = mu;
    return data;
  }
} // namespace



BOOST_AUTO_TEST_CASE(equals_brute_force)
{
  std::mt19937     generator(7);
  RandomComparison comparison;
  for (unsigned int trial = 0; trial < 1000; ++trial)
    {
      // Few of many contacts: brute force tries 4^m to 6^m states.
      const unsigned int m     = trial % 500 == 499 ? 8 :
                                 trial % 250 == 48  ? 7 :
                                 trial % 50 == 17   ? 6 :
                                 trial % 10 == 5    ? 5 :
                                                      2 + trial % 3;
      const unsigned int fewer = trial / 7 % 3;
      comparison.run(m > fewer ? m - fewer : 1, m, trial, generator);
    }
  BOOST_TEST_MESSAGE("one solution " << comparison.n_unique << ", several "
                                     << comparison.n_several << ", none "
                                     << comparison.n_without << "; fallbacks "
                                     << comparison.n_fallbacks);
  BOOST_TEST(comparison.n_unique > 800);
  BOOST_TEST(comparison.n_without < 150);
  BOOST_TEST(comparison.n_fallbacks < 200);
}



BOOST_AUTO_TEST_CASE(block_sticks_and_slides)
{
  // lambda = 3 N, so that with mu = 0.5 it slides from a pull of 1.5 N on.
  for (const Exact &exact : exact_algorithms())
    for (const double pull : {-4., -1.6, -1.4, 0., 1.4, 1.6, 4.})
      BOOST_TEST_CONTEXT(exact.algorithm->name() << ", pull " << pull)
      {
        const InterfaceProblem problem =
          InterfaceReference::make_problem(block(pull, 0.5));
        const InterfaceSolution found = exact.algorithm->solve(problem, {});
        const double            force = std::min(std::max(pull, -1.5), 1.5);
        BOOST_TEST(std::abs(found.forces.normal[0] - 3.) <= 1e-14);
        BOOST_TEST(std::abs(found.forces.tangential[0][0] - force) <= 1e-8);
        BOOST_TEST(std::abs(found.displacement(0) - (pull - force) / 3.) <=
                   1e-8);
        BOOST_TEST(found.n_fallbacks == 0);
        BOOST_TEST((found.is_slipping.at(0) != 0) == (std::abs(pull) > 1.5));
      }

  // Pulled with the greatest friction it sticks; a regularised law creeps.
  for (const Exact &exact : exact_algorithms())
    BOOST_TEST(exact.algorithm
                 ->solve(InterfaceReference::make_problem(block(1.5, 0.5)), {})
                 .is_slipping.at(0) == 0);

  // Exactly at rest, not nearly.
  for (const unsigned int i : {0, 1})
    {
      const InterfaceProblem problem =
        InterfaceReference::make_problem(block(1.4, 0.5));
      const InterfaceSolution found =
        exact_algorithms()[i].algorithm->solve(problem, {});
      BOOST_TEST(std::abs(found.displacement(0)) <= 1e-16);
    }
}



BOOST_AUTO_TEST_CASE(largest_friction_and_slip_so_far)
{
  for (const Exact &exact : exact_algorithms())
    BOOST_TEST_CONTEXT(exact.algorithm->name())
    {
      // 1. The bound is 0.6 N, not mu lambda = 1.5 N.
      auto data                         = block(4., 0.5);
      data.contacts[0].largest_friction = 0.6;
      const InterfaceSolution capped =
        exact.algorithm->solve(InterfaceReference::make_problem(data), {});
      BOOST_TEST(std::abs(capped.forces.tangential[0][0] - 0.6) <= 1e-12);

      // 2. It slipped by 0.1 m before this iteration and is pulled back by
      // 0.3 N = 3 N/m 0.1 m at most: it returns and sticks.
      data                     = block(0., 0.5);
      data.contacts[0].slip[0] = 0.1;
      const InterfaceSolution returned =
        exact.algorithm->solve(InterfaceReference::make_problem(data), {});
      BOOST_TEST(std::abs(returned.displacement(0) + 0.1) <= 1e-8);
      BOOST_TEST(std::abs(returned.forces.tangential[0][0] - 0.3) <= 1e-8);

      // 3. Without a coefficient there is no friction.
      data = block(4., 0.);
      const InterfaceSolution smooth =
        exact.algorithm->solve(InterfaceReference::make_problem(data), {});
      BOOST_TEST(smooth.forces.tangential[0][0] == 0.);
      BOOST_TEST(std::abs(smooth.displacement(0) - 4. / 3.) <= 1e-15);
    }
}



BOOST_AUTO_TEST_CASE(normal_and_tangent_strongly_coupled)
{
  // W = [1 -0.9; -0.9 1] and mu = 1.5, as in Painleve's paradox: sliding
  // forwards would need 1 - 0.9 mu < 0 times lambda to close the gap. Of
  // several solutions any will do.
  for (const double slip : {-1., -0.5, 0., 0.5, 1., 2.})
    for (const double gap : {-2., -1., -0.1})
      for (const Exact &exact : exact_algorithms())
        BOOST_TEST_CONTEXT(exact.algorithm->name()
                           << ", slip " << slip << ", gap " << gap)
        {
          InterfaceReference::Data data{dealii::FullMatrix<double>(2, 2),
                                        Vector<double>(2),
                                        {{{{0, 1.}}, gap, {{{1, 1.}}}}}};
          data.stiffness(0, 0) = data.stiffness(1, 1) = 1. / 0.19;
          data.stiffness(0, 1) = data.stiffness(1, 0) = 0.9 / 0.19;
          data.contacts[0].friction_coefficient       = 1.5;
          data.contacts[0].slip[0]                    = slip;
          const InterfaceProblem problem =
            InterfaceReference::make_problem(data);
          const InterfaceSolution found = exact.algorithm->solve(problem, {});
          BOOST_TEST(kkt_residual(problem, found).norm() <=
                     exact.residual_tolerance);
          BOOST_TEST(found.forces.normal[0] > 0.);
        }
}



BOOST_AUTO_TEST_CASE(redundant_contacts)
{
  // The same contact twice, and a third at the same node from the side.
  for (const double pull : {1., 5.})
    for (const Exact &exact : exact_algorithms())
      BOOST_TEST_CONTEXT(exact.algorithm->name() << ", pull " << pull)
      {
        auto data = block(pull, 0.5);
        data.contacts.push_back(data.contacts[0]);
        const InterfaceProblem problem = InterfaceReference::make_problem(data);
        const InterfaceSolution found  = exact.algorithm->solve(problem, {});
        BOOST_TEST(kkt_residual(problem, found).norm() <=
                   exact.residual_tolerance);
        const double single = std::min(pull, 1.5);
        BOOST_TEST(std::abs(found.forces.normal[0] + found.forces.normal[1] -
                            3.) <= 1e-12);
        BOOST_TEST(std::abs(found.displacement(0) - (pull - single) / 3.) <=
                   1e-8);

        data.contacts[1]                      = {{{0, 1.}}, 0.2, {{{1, 1.}}}};
        data.contacts[1].friction_coefficient = 0.5;
        const InterfaceProblem  corner = InterfaceReference::make_problem(data);
        const InterfaceSolution inside = exact.algorithm->solve(corner, {});
        BOOST_TEST(kkt_residual(corner, inside).norm() <=
                   exact.residual_tolerance);
      }
}



BOOST_AUTO_TEST_CASE(out_of_reach_is_left_out)
{
  for (const Exact &exact : exact_algorithms())
    BOOST_TEST_CONTEXT(exact.algorithm->name())
    {
      auto             data = block(4., 0.5);
      InterfaceContact far;
      far.gap                  = std::numeric_limits<double>::infinity();
      far.tangents             = {SparseRow()};
      far.friction_coefficient = 0.5;
      data.contacts.insert(data.contacts.begin(), far);
      const InterfaceProblem problem = InterfaceReference::make_problem(data);
      InterfaceForces        start(2);
      start.normal                  = {5., 1.};
      const InterfaceSolution found = exact.algorithm->solve(problem, start);
      BOOST_TEST(found.forces.normal[0] == 0.);
      BOOST_TEST(std::abs(found.forces.tangential[1][0] - 1.5) <= 1e-12);
      BOOST_TEST(kkt_residual(problem, found).norm() <=
                 exact.residual_tolerance);
    }
}



BOOST_AUTO_TEST_CASE(independent_of_units)
{
  // m-kg-s and mm-t-s, and one that nobody uses.
  std::mt19937 generator(21);
  for (unsigned int trial = 0; trial < 60; ++trial)
    {
      const unsigned int m = 2 + trial % 6;
      const auto data      = FrictionReference::random_problem(m, m, generator);
      for (const Exact &exact : exact_algorithms())
        for (const auto &[length, force] :
             {std::pair(1e3, 1.), std::pair(1. / 1024., 1024. * 1024.)})
          BOOST_TEST_CONTEXT("trial " << trial << ", "
                                      << exact.algorithm->name())
          {
            const InterfaceProblem problem =
              InterfaceReference::make_problem(data);
            const InterfaceProblem other_problem =
              InterfaceReference::make_problem(
                FrictionReference::in_units(data, length, force));
            InterfaceSolution solution, other;
            try
              {
                solution = exact.algorithm->solve(problem, {});
              }
            catch (const InterfaceError &)
              {
                // Two contacts at one node may jam, in all units.
                BOOST_CHECK_THROW(exact.algorithm->solve(other_problem, {}),
                                  InterfaceError);
                continue;
              }
            other = exact.algorithm->solve(other_problem, {});
            // Powers of two change no digit; where rounding decides, others
            // may take one state more.
            if (length < 1.)
              {
                BOOST_TEST(other.n_iterations == solution.n_iterations);
                BOOST_TEST(other.n_fallbacks == solution.n_fallbacks);
              }
            for (unsigned int k = 0; k < m; ++k)
              BOOST_TEST(std::abs(other.forces.tangential[k][0] / force -
                                  solution.forces.tangential[k][0]) <= 1e-6);
          }
    }
}



BOOST_AUTO_TEST_CASE(warm_start)
{
  // From its own forces, exact algorithms confirm the state in one iteration;
  // a second one may be refinement.
  std::mt19937 generator(22);
  for (unsigned int trial = 0; trial < 100; ++trial)
    {
      const unsigned int m = 2 + trial % 6;
      const auto data      = FrictionReference::random_problem(m, m, generator);
      const InterfaceProblem problem = InterfaceReference::make_problem(data);
      for (const unsigned int i : {0, 1})
        {
          const auto algorithm = std::move(exact_algorithms()[i].algorithm);
          try
            {
              const InterfaceSolution found = algorithm->solve(problem, {});
              if (found.n_iterations > 0)
                BOOST_TEST(
                  algorithm->solve(problem, found.forces).n_iterations <= 2);
            }
          catch (const InterfaceError &)
            {}
        }
    }
}



BOOST_AUTO_TEST_CASE(three_dimensions_are_refused_where_unknown)
{
  std::mt19937 generator(23);
  const auto   data =
    FrictionReference::random_spatial_problem(2, 2, false, generator);
  auto pressed                   = data;
  pressed.contacts[0].gap        = -10.;
  const InterfaceProblem problem = InterfaceReference::make_problem(pressed);
  for (const unsigned int i : {1, 2})
    try
      {
        exact_algorithms()[i].algorithm->solve(problem, {});
        BOOST_ERROR("accepted in three dimensions");
      }
    catch (const InputError &error)
      {
        BOOST_TEST(std::string(error.what()).find("semismooth Newton") !=
                   std::string::npos);
      }
}

BOOST_AUTO_TEST_SUITE_END()
