#include <signorini/variational_inequality/kkt_residual.h>

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <limits>

#include "interface_reference.h"

BOOST_AUTO_TEST_SUITE(kkt_conditions)

using namespace Signorini;
using dealii::FullMatrix;
using dealii::Vector;

namespace
{
  // S = [2 1; 1 2] k, gaps (1, 5) a: pressed by r = (-11, -3) k a, the first of
  // two nodes stops at -1 a under the force 8 k a, the second goes to -1 a.
  struct Example
  {
    InterfaceProblem  problem;
    InterfaceSolution solution;
    double            stiffness_unit;
    double            length_unit;
  };

  Example
  example(const double k, const double a)
  {
    InterfaceReference::Data data{FullMatrix<double>(2, 2),
                                  Vector<double>(2),
                                  {{{{0, -1.}}, a}, {{{1, -1.}}, 5. * a}}};
    data.stiffness(0, 0) = data.stiffness(1, 1) = 2. * k;
    data.stiffness(0, 1) = data.stiffness(1, 0) = k;
    data.force(0)                               = -11. * k * a;
    data.force(1)                               = -3. * k * a;
    Example result{InterfaceReference::make_problem(data), {}, k, a};
    result.solution.displacement.reinit(2);
    result.solution.displacement(0) = -a;
    result.solution.displacement(1) = -a;
    result.solution.forces.normal   = {8. * k * a, 0.};
    return result;
  }
} // namespace



BOOST_AUTO_TEST_CASE(exact_solution)
{
  for (const double k : {1., 7.3e11, 1e-9})
    for (const double a : {1., 5e-5, 1e6})
      {
        const Example     exact = example(k, a);
        const KKTResidual residual =
          kkt_residual(exact.problem, exact.solution);
        BOOST_TEST(residual.norm() <= 1e-15);
        BOOST_TEST(residual.force_scale / (11. * k * a) == 1.,
                   boost::test_tools::tolerance(1e-14));
        // The free displacement of the first node is -19/3 a.
        BOOST_TEST(residual.length_scale / (19. / 3. * a) == 1.,
                   boost::test_tools::tolerance(1e-14));
      }
}



BOOST_AUTO_TEST_CASE(each_violation_is_noticed)
{
  // The same numbers in every system of units: relative to 11 k a and 19/3 a.
  for (const double k : {1., 7.3e11})
    for (const double a : {1., 5e-5})
      {
        const auto check = [&](const std::function<void(Example &)> &change,
                               const double                          expected,
                               const double KKTResidual::*part,
                               const double               expected_part) {
          Example wrong = example(k, a);
          change(wrong);
          const KKTResidual residual =
            kkt_residual(wrong.problem, wrong.solution);
          BOOST_TEST(residual.norm() == expected,
                     boost::test_tools::tolerance(1e-12));
          BOOST_TEST((residual.*part) == expected_part,
                     boost::test_tools::tolerance(1e-12));
        };
        // A force too large.
        check([&](Example &e) { e.solution.forces.normal[0] += 1.1 * k * a; },
              0.1,
              &KKTResidual::stationarity,
              0.1);
        // The first gap smaller by 1.9 a: penetration alone.
        check([&](Example &e) { e.problem.set_gap(0, -0.9 * a); },
              0.3,
              &KKTResidual::penetration,
              1.9 * a);
        // Larger by 1.9 a: a force across a gap.
        check([&](Example &e) { e.problem.set_gap(0, 2.9 * a); },
              0.3,
              &KKTResidual::complementarity,
              0.3);
        // A small force across a wide gap: 1.1e-2 k a in 4 a.
        check([&](Example &e) { e.solution.forces.normal[1] = 1.1e-2 * k * a; },
              1e-3,
              &KKTResidual::complementarity,
              1e-3);
        // A force that pulls.
        check([&](Example &e) { e.solution.forces.normal[1] = -2.2 * k * a; },
              0.2,
              &KKTResidual::negative_force,
              2.2 * k * a);
      }
}



BOOST_AUTO_TEST_CASE(violations_of_friction)
{
  // S = 3 k in x and y, pressed with 6 k a onto a floor at y = -a and pulled
  // with p k a along it: lambda = 3 k a, f = 1.5 k a.
  const auto residual = [](const double                 k,
                           const double                 a,
                           const double                 pull,
                           const double                 tau,
                           const std::array<double, 2> &slip_so_far) {
    InterfaceReference::Data data{FullMatrix<double>(3, 3),
                                  Vector<double>(3),
                                  {{{{1, -1.}}, a, {{{0, 1.}}, {{2, 1.}}}}}};
    for (unsigned int i = 0; i < 3; ++i)
      data.stiffness(i, i) = 3. * k;
    data.force(0)                         = pull * k * a;
    data.force(1)                         = -6. * k * a;
    data.contacts[0].friction_coefficient = 0.5;
    data.contacts[0].slip = {{slip_so_far[0] * a, slip_so_far[1] * a}};
    InterfaceSolution solution;
    solution.displacement.reinit(3);
    solution.displacement(0) = (pull - tau) / 3. * a;
    solution.displacement(1) = -a;
    solution.forces          = InterfaceForces(std::vector<double>{3. * k * a});
    solution.forces.tangential[0][0] = tau * k * a;
    return kkt_residual(InterfaceReference::make_problem(data), solution);
  };
  // F = 6 k a and l = 2 a.
  for (const double k : {1., 7.3e11})
    for (const double a : {1., 5e-5})
      {
        const auto tolerance = boost::test_tools::tolerance(1e-12);
        BOOST_TEST(residual(k, a, 1.2, 1.2, {{0., 0.}}).norm() <= 1e-15);
        BOOST_TEST(residual(k, a, 3., 1.5, {{0., 0.}}).norm() <= 1e-15);
        // Slip 0.1 a under half the bound: min(0.1 / 2, 0.75 / 6).
        BOOST_TEST(residual(k, a, 1.05, 0.75, {{0., 0.}}).norm() == 0.05,
                   tolerance);
        // Slip 1.0 a under half the bound.
        BOOST_TEST(residual(k, a, 3.75, 0.75, {{0., 0.}}).norm() == 0.125,
                   tolerance);
        // A force of 2.1 beyond the bound of 1.5.
        BOOST_TEST(residual(k, a, 2.1, 2.1, {{0., 0.}}).friction_excess ==
                     0.6 * k * a,
                   tolerance);
        BOOST_TEST(residual(k, a, 2.1, 2.1, {{0., 0.}}).norm() == 0.1,
                   tolerance);
        // Slip against the force, and across it.
        BOOST_TEST(residual(k, a, 1.5, 1.5, {{-0.2, 0.}}).norm() == 0.1,
                   tolerance);
        BOOST_TEST(residual(k, a, 1.5, 1.5, {{0., 0.4}}).friction > 0.1);
      }
}



BOOST_AUTO_TEST_CASE(zero_problems)
{
  // 1. No force, no gap, no displacement.
  InterfaceReference::Data data{FullMatrix<double>(2, 2),
                                Vector<double>(2),
                                {{{{0, -1.}}, 0.}}};
  data.stiffness(0, 0) = data.stiffness(1, 1) = 1.;
  const InterfaceProblem at_rest = InterfaceReference::make_problem(data);
  InterfaceSolution      nothing;
  nothing.displacement.reinit(2);
  nothing.forces.normal = {0.};
  BOOST_TEST(kkt_residual(at_rest, nothing).norm() == 0.);

  // 2. Penetrated from the start, and left so.
  data.contacts[0].gap          = -1e-6;
  const InterfaceProblem inside = InterfaceReference::make_problem(data);
  BOOST_TEST(kkt_residual(inside, nothing).norm() == 1.,
             boost::test_tools::tolerance(1e-14));

  // 3. No contacts.
  data.contacts.clear();
  nothing.forces.normal.clear();
  BOOST_TEST(
    kkt_residual(InterfaceReference::make_problem(data), nothing).norm() == 0.);
}



BOOST_AUTO_TEST_CASE(nothing_touches_and_nothing_moves)
{
  // A tool slides by above, with friction: its slip is no slip of a contact.
  InterfaceReference::Data data{FullMatrix<double>(2, 2),
                                Vector<double>(2),
                                {{{{1, -1.}}, 0.5, {{{0, 1.}}}}}};
  data.stiffness(0, 0) = data.stiffness(1, 1) = 1.;
  data.contacts[0].friction_coefficient       = 0.3;
  data.contacts[0].slip                       = {{0.1, 0.}};
  InterfaceSolution nothing;
  nothing.displacement.reinit(2);
  nothing.forces     = InterfaceForces(1);
  const auto at_rest = InterfaceReference::make_problem(data);
  BOOST_TEST(kkt_residual(at_rest, nothing).norm() == 0.);

  // Friction without pressure is still wrong.
  nothing.forces.tangential[0][0] = 1.;
  BOOST_TEST(kkt_residual(at_rest, nothing).norm() >= 1.);
}



BOOST_AUTO_TEST_CASE(rounding_is_no_violation)
{
  // A gap of which nothing is known but that it is within 1e-16 m of zero.
  InterfaceReference::Data data{FullMatrix<double>(1, 1),
                                Vector<double>(1),
                                {{{{0, -1.}}, -5e-17}}};
  data.stiffness(0, 0) = 1.;
  InterfaceSolution nothing;
  nothing.displacement.reinit(1);
  nothing.forces = InterfaceForces(1);
  BOOST_TEST(
    kkt_residual(InterfaceReference::make_problem(data), nothing).norm() >
    0.99);
  data.contacts[0].rounding = 1e-16;
  BOOST_TEST(
    kkt_residual(InterfaceReference::make_problem(data), nothing).norm() == 0.);
  data.contacts[0].gap = -5e-16;
  BOOST_TEST(
    kkt_residual(InterfaceReference::make_problem(data), nothing).norm() > 0.5);
}



BOOST_AUTO_TEST_CASE(not_a_number)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (unsigned int place = 0; place < 4; ++place)
    {
      Example broken = example(1., 1.);
      if (place == 0)
        broken.solution.displacement(1) = nan;
      else if (place == 1)
        broken.solution.forces.normal[1] = nan;
      else if (place == 2)
        broken.problem.set_gap(1, nan);
      else
        broken.problem.set_gap(1, -std::numeric_limits<double>::infinity());
      const double norm = kkt_residual(broken.problem, broken.solution).norm();
      BOOST_TEST(norm == std::numeric_limits<double>::infinity());
    }
}

BOOST_AUTO_TEST_SUITE_END()
