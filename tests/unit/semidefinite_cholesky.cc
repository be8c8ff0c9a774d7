#include <signorini/variational_inequality/semidefinite_cholesky.h>

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cmath>

BOOST_AUTO_TEST_SUITE(semidefinite_cholesky)

using namespace Signorini;
using dealii::FullMatrix;

namespace
{
  // Rows (1,0,1), (0,1,1), their sum, and the first again, in units that
  // differ by many decades; rank 2.
  FullMatrix<double>
  rank_two()
  {
    const double rows[4][3] = {{1, 0, 1}, {0, 1, 1}, {1, 1, 2}, {1, 0, 1}};
    const double unit[4]    = {1., 1e-7, 1e5, 1e9};
    FullMatrix<double> W(4, 4);
    for (unsigned int i = 0; i < 4; ++i)
      for (unsigned int j = 0; j < 4; ++j)
        for (unsigned int c = 0; c < 3; ++c)
          W(i, j) += unit[i] * unit[j] * rows[i][c] * rows[j][c];
    return W;
  }

  // Entry i of W z relative to the terms of its sum.
  double
  relative_row(const FullMatrix<double>  &W,
               const unsigned int         i,
               const std::vector<double> &z,
               const double               b)
  {
    double sum = -b, size = std::abs(b);
    for (unsigned int j = 0; j < z.size(); ++j)
      {
        sum += W(i, j) * z[j];
        size += std::abs(W(i, j) * z[j]);
      }
    return size > 0. ? std::abs(sum) / size : 0.;
  }
} // namespace



BOOST_AUTO_TEST_CASE(rank_solution_and_null_direction)
{
  const FullMatrix<double>        W   = rank_two();
  const std::vector<unsigned int> all = {0, 1, 2, 3};
  const SemidefiniteCholesky      factor(W, all);
  BOOST_TEST(factor.rank() == 2);
  BOOST_TEST(factor.dependent().size() == 2);

  // 1. b in the range of W.
  std::vector<double> b(4);
  for (unsigned int i = 0; i < 4; ++i)
    b[i] = W(i, 0) * 2. + W(i, 1) * 1e7;
  const std::vector<double> p = factor.solve(b);
  for (unsigned int i = 0; i < 4; ++i)
    BOOST_TEST(relative_row(W, i, p, b[i]) < 1e-14);
  for (const unsigned int i : factor.dependent())
    BOOST_TEST(p[i] == 0.);

  // 2. A direction of zero curvature that descends.
  std::vector<double> remainder(4, 0.);
  const unsigned int  j       = factor.dependent()[0];
  remainder[j]                = -3.;
  const std::vector<double> z = factor.null_direction(remainder);
  BOOST_TEST(z[j] < 0.);
  for (unsigned int i = 0; i < 4; ++i)
    BOOST_TEST(relative_row(W, i, z, 0.) < 1e-14);
}



BOOST_AUTO_TEST_CASE(blocks)
{
  const FullMatrix<double> W = rank_two();
  BOOST_TEST(SemidefiniteCholesky(W, {0, 3}).rank() == 1);
  BOOST_TEST(SemidefiniteCholesky(W, {0, 1}).rank() == 2);
  BOOST_TEST(SemidefiniteCholesky(W, {1, 2}).rank() == 2);
  BOOST_TEST(SemidefiniteCholesky(W, {}).rank() == 0);
  BOOST_TEST(SemidefiniteCholesky(FullMatrix<double>(3, 3), {0, 2}).rank() ==
             0);
}

BOOST_AUTO_TEST_SUITE_END()
