#include <signorini/variational_inequality/lemke.h>

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <random>

BOOST_AUTO_TEST_SUITE(lemke)

using namespace Signorini;
using dealii::FullMatrix;

namespace
{
  void
  check_solution(const FullMatrix<double>  &M,
                 const std::vector<double> &q,
                 const std::vector<double> &z)
  {
    for (unsigned int i = 0; i < q.size(); ++i)
      {
        double w = q[i];
        for (unsigned int j = 0; j < q.size(); ++j)
          w += M(i, j) * z[j];
        BOOST_TEST(z[i] >= 0.);
        BOOST_TEST(w >= -1e-9);
        BOOST_TEST(std::abs(w * z[i]) <= 1e-8);
      }
  }
} // namespace



BOOST_AUTO_TEST_CASE(positive_definite_problems)
{
  std::mt19937                           generator(1);
  std::uniform_real_distribution<double> real(-1., 1.);
  for (unsigned int trial = 0; trial < 200; ++trial)
    BOOST_TEST_CONTEXT("trial " << trial)
    {
      // Unsymmetric on purpose.
      const unsigned int n = 1 + trial % 12;
      FullMatrix<double> B(n, n), M(n, n);
      for (unsigned int i = 0; i < n; ++i)
        for (unsigned int j = 0; j < n; ++j)
          B(i, j) = real(generator);
      B.mTmult(M, B);
      for (unsigned int i = 0; i < n; ++i)
        for (unsigned int j = 0; j < i; ++j)
          {
            const double skew = real(generator);
            M(i, j) += skew;
            M(j, i) -= skew;
          }
      M.diagadd(0.1);
      std::vector<double> q(n), cover(n);
      for (unsigned int i = 0; i < n; ++i)
        {
          q[i]     = real(generator);
          cover[i] = 1.5 + real(generator);
        }
      const auto z = solve_complementarity(M, q, cover);
      BOOST_REQUIRE(z.has_value());
      check_solution(M, q, *z);
    }
}



BOOST_AUTO_TEST_CASE(without_a_solution)
{
  // w = -1 - z is negative for every z >= 0.
  FullMatrix<double> M(1, 1);
  M(0, 0) = -1.;
  BOOST_TEST(!solve_complementarity(M, {-1.}, {1.}).has_value());
  BOOST_TEST(
    (*solve_complementarity(M, {2.}, {1.}) == std::vector<double>{0.}));
  BOOST_TEST(
    (*solve_complementarity(M, {0.}, {1.}) == std::vector<double>{0.}));
}

BOOST_AUTO_TEST_SUITE_END()
