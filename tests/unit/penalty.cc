#include <signorini/input/input_error.h>
#include <signorini/variational_inequality/penalty.h>

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <random>

#include "interface_reference.h"

BOOST_AUTO_TEST_SUITE(penalty)

using namespace Signorini;
using dealii::Vector;

namespace
{
  // (S + K_N A^T A) du = r + K_N A^T G over the contacts that carry a force.
  Vector<double>
  displacement_by_contact_elements(const InterfaceReference::Data &data,
                                   const double                    stiffness,
                                   const std::vector<double>      &forces)
  {
    const unsigned int         n = data.force.size();
    InterfaceReference::Matrix K(n, InterfaceReference::Column(n));
    InterfaceReference::Column b(n);
    for (unsigned int i = 0; i < n; ++i)
      {
        b[i] = data.force(i);
        for (unsigned int j = 0; j < n; ++j)
          K[i][j] = data.stiffness(i, j);
      }
    for (unsigned int k = 0; k < forces.size(); ++k)
      if (forces[k] > 0.)
        for (const auto &[i, a] : data.contacts[k].normal)
          {
            b[i] += stiffness * a * data.contacts[k].gap;
            for (const auto &[j, c] : data.contacts[k].normal)
              K[i][j] += stiffness * a * c;
          }
    const auto     x = InterfaceReference::solve(K, b);
    Vector<double> du(n);
    BOOST_REQUIRE(x.has_value());
    for (unsigned int i = 0; i < n; ++i)
      du(i) = static_cast<double>((*x)[i]);
    return du;
  }
} // namespace



BOOST_AUTO_TEST_CASE(equals_contact_elements)
{
  std::mt19937 generator(31);
  unsigned int n_with_contact = 0;
  double       worst          = 0.;
  for (unsigned int trial = 0; trial < 300; ++trial)
    BOOST_TEST_CONTEXT("trial " << trial)
    {
      const unsigned int n = 2 + trial % 5, m = 1 + trial % 7;
      const double       stiffness = std::pow(10., trial % 6 - 1.);
      const auto data = InterfaceReference::random_problem(n, m, generator);
      const InterfaceProblem  problem = InterfaceReference::make_problem(data);
      const InterfaceSolution found   = Penalty(stiffness).solve(problem, {});
      const Vector<double>    expected =
        displacement_by_contact_elements(data, stiffness, found.forces.normal);
      const double   scale = 1. + problem.free_displacement().linfty_norm();
      Vector<double> difference = found.displacement;
      difference -= expected;
      worst = std::max(worst, difference.linfty_norm() / scale);
      BOOST_TEST(difference.linfty_norm() <= 1e-11 * scale);

      // The law of the elements itself; the active set is right by it.
      bool closed = false;
      for (unsigned int k = 0; k < m; ++k)
        {
          const double penetration =
            std::max(0., -problem.gap_after(k, expected));
          BOOST_TEST(
            std::abs(found.forces.normal[k] - stiffness * penetration) <=
            1e-10 * scale * stiffness);
          closed = closed || penetration > 0.;
        }
      n_with_contact += closed;
    }
  BOOST_TEST_MESSAGE("with contact " << n_with_contact << ", difference "
                                     << worst);
  BOOST_TEST(n_with_contact > 200);
}



BOOST_AUTO_TEST_CASE(penetration_falls_with_the_stiffness)
{
  // One node, S = 3, r = -6, gap 1: lambda = K / (1 + K / 3).
  InterfaceReference::Data data{dealii::FullMatrix<double>(1, 1),
                                Vector<double>(1),
                                {{{{0, -1.}}, 1.}}};
  data.stiffness(0, 0)           = 3.;
  data.force(0)                  = -6.;
  const InterfaceProblem problem = InterfaceReference::make_problem(data);
  for (const double K : {1e-3, 1., 30., 1e4, 1e12})
    {
      const InterfaceSolution solution = Penalty(K).solve(problem, {});
      const double            force    = K / (1. + K / 3.);
      BOOST_TEST(std::abs(solution.forces.normal[0] - force) <= 1e-14 * force);
      BOOST_TEST(std::abs(solution.displacement(0) + (6. - force) / 3.) <=
                 1e-14);
    }
}



BOOST_AUTO_TEST_CASE(friction_by_hand)
{
  // One node, S = 3 in x and y, r = (p, -6), gap 1, mu = 0.5:
  // lambda = K / (1 + K / 3), tau = K_T p / (3 + K_T) up to mu lambda.
  for (const double pull : {-2., 0.3, 1.3, 5.})
    for (const double K : {1., 30., 1e6})
      for (const double K_T : {0., 2., 1e9})
        {
          InterfaceReference::Data data{dealii::FullMatrix<double>(2, 2),
                                        Vector<double>(2),
                                        {{{{1, -1.}}, 1., {{{0, 1.}}}}}};
          data.stiffness(0, 0) = data.stiffness(1, 1) = 3.;
          data.force(0)                               = pull;
          data.force(1)                               = -6.;
          data.contacts[0].friction_coefficient       = 0.5;
          const InterfaceSolution solution =
            Penalty(K, K_T).solve(InterfaceReference::make_problem(data), {});
          const double tangential = K_T == 0. ? K : K_T;
          const double lambda     = K / (1. + K / 3.);
          const double stick      = tangential * pull / (3. + tangential);
          const double tau =
            std::min(std::max(stick, -0.5 * lambda), 0.5 * lambda);
          BOOST_TEST(std::abs(solution.forces.normal[0] - lambda) <= 1e-13);
          BOOST_TEST(std::abs(solution.forces.tangential[0][0] - tau) <= 1e-13);
          BOOST_TEST(std::abs(solution.displacement(0) - (pull - tau) / 3.) <=
                     1e-13);
        }
}



BOOST_AUTO_TEST_CASE(stiffness_has_to_be_positive)
{
  BOOST_CHECK_THROW(Penalty(1., -1.), InputError);
  BOOST_CHECK_THROW(Penalty(0.), InputError);
  BOOST_CHECK_THROW(Penalty(-1.), InputError);
  BOOST_CHECK_THROW(Penalty(std::numeric_limits<double>::infinity()),
                    InputError);
}

BOOST_AUTO_TEST_SUITE_END()
