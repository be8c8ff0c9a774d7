#include <signorini/input/input_error.h>
#include <signorini/variational_inequality/interface_stiffness.h>

#include <boost/test/unit_test.hpp>

#include <random>

#include "interface_reference.h"

BOOST_AUTO_TEST_SUITE(interface_stiffness)

using namespace Signorini;
using dealii::FullMatrix;
using dealii::Vector;

namespace
{
  // L = [2 0 0; 1 3 0; -1 2 1], by columns; 99 must not be read.
  InterfaceStiffness
  small()
  {
    return InterfaceStiffness::from_cholesky_factor(
      3, {2., 1., -1., 99., 3., 2., 99., 99., 1.});
  }

  void
  check_equal(const Vector<double> &x, const std::vector<double> &expected)
  {
    for (unsigned int i = 0; i < x.size(); ++i)
      BOOST_TEST(x(i) == expected[i], boost::test_tools::tolerance(1e-15));
  }

  template <typename Operation>
  Vector<double>
  applied(const Operation &operation, const std::vector<double> &numbers)
  {
    Vector<double> x(numbers.begin(), numbers.end());
    operation(x);
    return x;
  }
} // namespace



BOOST_AUTO_TEST_CASE(products_and_solutions_by_hand)
{
  const InterfaceStiffness stiffness = small();
  BOOST_TEST(stiffness.size() == 3);
  const auto is = [&](void (InterfaceStiffness::*operation)(Vector<double> &)
                        const,
                      const std::vector<double> &x,
                      const std::vector<double> &expected) {
    check_equal(applied([&](Vector<double> &y) { (stiffness.*operation)(y); },
                        x),
                expected);
  };
  is(&InterfaceStiffness::multiply_factor, {1., 2., 3.}, {2., 7., 6.});
  is(&InterfaceStiffness::solve_factor, {2., 7., 6.}, {1., 2., 3.});
  is(&InterfaceStiffness::multiply_transposed_factor,
     {1., 2., 3.},
     {1., 12., 3.});
  is(&InterfaceStiffness::solve_transposed_factor, {1., 12., 3.}, {1., 2., 3.});
  is(&InterfaceStiffness::multiply, {1., 2., 3.}, {2., 37., 26.});
  is(&InterfaceStiffness::solve, {2., 37., 26.}, {1., 2., 3.});

  std::vector<double> columns = {2., 37., 26., 4., 2., -2.};
  stiffness.solve_columns(columns, 2);
  check_equal(Vector<double>(columns.begin(), columns.begin() + 3),
              {1., 2., 3.});
  check_equal(Vector<double>(columns.begin() + 3, columns.end()), {1., 0., 0.});

  const FullMatrix<double> S  = stiffness.matrix();
  const double expected[3][3] = {{4, 2, -2}, {2, 10, 5}, {-2, 5, 6}};
  for (unsigned int i = 0; i < 3; ++i)
    for (unsigned int j = 0; j < 3; ++j)
      BOOST_TEST(S(i, j) == expected[i][j]);
}



BOOST_AUTO_TEST_CASE(matrix_is_factorised)
{
  std::mt19937             generator(3);
  const FullMatrix<double> S =
    InterfaceReference::random_stiffness(60, generator);
  const InterfaceStiffness stiffness = InterfaceStiffness::from_matrix(S);
  FullMatrix<double>       difference(stiffness.matrix());
  difference.add(-1., S);
  BOOST_TEST(difference.frobenius_norm() <= 1e-14 * S.frobenius_norm());

  Vector<double> x(60), y(60);
  for (unsigned int i = 0; i < 60; ++i)
    x(i) = i % 5 - 2.;
  S.vmult(y, x);
  stiffness.solve(y);
  y -= x;
  BOOST_TEST(y.linfty_norm() <= 1e-10);
}



// S is formed in blocks, and factorised in its own place.
BOOST_AUTO_TEST_CASE(matrices_of_every_size)
{
  std::mt19937 generator(4);
  for (const unsigned int n : {1U, 31U, 128U, 129U, 300U})
    {
      std::uniform_int_distribution<int> number(1, 9);
      std::vector<double>                lower(n * n, 1e9);
      FullMatrix<double>                 expected(n, n);
      for (unsigned int j = 0; j < n; ++j)
        for (unsigned int i = j; i < n; ++i)
          lower[i + j * n] = number(generator);
      for (unsigned int i = 0; i < n; ++i)
        for (unsigned int j = 0; j < n; ++j)
          for (unsigned int k = 0; k <= std::min(i, j); ++k)
            expected(i, j) += lower[i + k * n] * lower[j + k * n];
      const auto stiffness = InterfaceStiffness::from_cholesky_factor(n, lower);
      BOOST_TEST((stiffness.matrix() == expected)); // integers: exact

      // Copies share what they hold.
      const InterfaceStiffness copy = stiffness;
      BOOST_TEST(&copy.matrix() == &stiffness.matrix());

      for (unsigned int i = 0; i < n; ++i)
        expected(i, i) += 100. * n * n;
      const auto         definite = InterfaceStiffness::from_matrix(expected);
      FullMatrix<double> difference(definite.matrix());
      difference.add(-1., expected);
      BOOST_TEST(difference.frobenius_norm() <=
                 1e-14 * expected.frobenius_norm());
    }
}



BOOST_AUTO_TEST_CASE(products_of_every_size)
{
  // Against the sums written out; small and large sizes use other kernels.
  for (const unsigned int n : {1U, 2U, 99U, 401U, 450U})
    {
      std::vector<double> lower(n * n);
      for (unsigned int i = 0; i < n * n; ++i)
        lower[i] = 1. + (i * 7) % 11;
      const std::vector<double> copy = lower;
      const InterfaceStiffness  stiffness =
        InterfaceStiffness::from_cholesky_factor(n, lower);
      Vector<double> x(n), product(n), transposed(n);
      for (unsigned int i = 0; i < n; ++i)
        x(i) = i % 9 - 3.;
      for (unsigned int i = 0; i < n; ++i)
        for (unsigned int j = 0; j <= i; ++j)
          {
            product(i) += copy[i + j * n] * x(j);
            transposed(j) += copy[i + j * n] * x(i);
          }
      // Integers: exact.
      Vector<double> y = x;
      stiffness.multiply_factor(y);
      BOOST_TEST((y == product));
      y = x;
      stiffness.multiply_transposed_factor(y);
      BOOST_TEST((y == transposed));
    }
}



BOOST_AUTO_TEST_CASE(indefinite_is_refused)
{
  FullMatrix<double> S(2, 2);
  S(0, 0) = S(1, 1) = 1.;
  S(0, 1) = S(1, 0) = 2.;
  BOOST_CHECK_THROW(InterfaceStiffness::from_matrix(S), ComputationError);
  BOOST_CHECK_THROW(InterfaceStiffness::from_cholesky_factor(1, {0.}),
                    ComputationError);
  BOOST_CHECK_THROW(InterfaceStiffness::from_cholesky_factor(
                      1, {std::numeric_limits<double>::quiet_NaN()}),
                    ComputationError);
}



BOOST_AUTO_TEST_CASE(nothing_at_all)
{
  InterfaceStiffness stiffness =
    InterfaceStiffness::from_matrix(FullMatrix<double>());
  Vector<double> x;
  stiffness.solve(x);
  BOOST_TEST(stiffness.matrix().m() == 0);
}

BOOST_AUTO_TEST_SUITE_END()
