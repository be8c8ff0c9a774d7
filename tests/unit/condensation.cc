#include <signorini/linear_algebra/cholesky_condensation.h>

#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/full_matrix.h>

#include <boost/test/unit_test.hpp>

#include <random>

BOOST_AUTO_TEST_SUITE(condensation)

using namespace Signorini;
using namespace dealii;

namespace
{
  // A random symmetric, diagonally dominant matrix on a random pattern.
  struct System
  {
    SparsityPattern      pattern;
    SparseMatrix<double> matrix;

    System(const unsigned int n, std::mt19937 &random)
    {
      DynamicSparsityPattern                      dynamic(n);
      std::uniform_int_distribution<unsigned int> index(0, n - 1);
      for (unsigned int i = 0; i < n; ++i)
        {
          dynamic.add(i, i);
          for (unsigned int k = 0; k < 4; ++k)
            {
              const unsigned int j = index(random);
              dynamic.add(i, j);
              dynamic.add(j, i);
            }
        }
      pattern.copy_from(dynamic);
      matrix.reinit(pattern);
      std::uniform_real_distribution<double> value(-1., 1.);
      for (unsigned int i = 0; i < n; ++i)
        for (auto entry = pattern.begin(i); entry != pattern.end(i); ++entry)
          if (entry->column() < i)
            {
              const double v = value(random);
              matrix.set(i, entry->column(), v);
              matrix.set(entry->column(), i, v);
              matrix.add(i, i, std::abs(v));
              matrix.add(entry->column(), entry->column(), std::abs(v));
            }
      for (unsigned int i = 0; i < n; ++i)
        matrix.add(i, i, 0.1);
    }
  };

  // The free part of the matrix, interior first, interface last, as a dense
  // matrix.
  FullMatrix<double>
  dense(const SparseMatrix<double>      &matrix,
        const std::vector<unsigned int> &rows,
        const std::vector<unsigned int> &columns)
  {
    FullMatrix<double> result(rows.size(), columns.size());
    for (unsigned int i = 0; i < rows.size(); ++i)
      for (unsigned int j = 0; j < columns.size(); ++j)
        result(i, j) = matrix.el(rows[i], columns[j]);
    return result;
  }
} // namespace



// S, the condensed force and the expanded solution against dense algebra.
BOOST_AUTO_TEST_CASE(equals_dense_schur_complement)
{
  std::mt19937 random(7);
  for (const unsigned int n : {12u, 60u, 300u})
    {
      const System              system(n, random);
      std::vector<bool>         is_fixed(n);
      std::vector<unsigned int> interior, interface;
      for (unsigned int i = 0; i < n; ++i)
        if (i % 7 == 3)
          is_fixed[i] = true;
        else if (i % 5 == 0)
          interface.push_back(i);
        else
          interior.push_back(i);
      std::reverse(interface.begin(), interface.end()); // any order

      CholeskyCondensation solver;
      solver.prepare(system.pattern, is_fixed, interface);
      solver.factorise(system.matrix);

      // S = K_cc - K_ci K_ii^-1 K_ic
      FullMatrix<double> K_ii = dense(system.matrix, interior, interior);
      const auto         K_ic = dense(system.matrix, interior, interface);
      FullMatrix<double> S    = dense(system.matrix, interface, interface);
      K_ii.gauss_jordan();
      FullMatrix<double> product(interior.size(), interface.size());
      K_ii.mmult(product, K_ic);
      FullMatrix<double> correction(interface.size(), interface.size());
      K_ic.Tmmult(correction, product);
      S.add(-1., correction);
      FullMatrix<double> difference = solver.interface_stiffness().matrix();
      difference.add(-1., S);
      BOOST_TEST(difference.frobenius_norm() < 1e-12 * S.frobenius_norm());

      // With no constraint the expanded solution solves K u = r on the free.
      Vector<double> r(n), u(n), image(n);
      for (unsigned int i = 0; i < n; ++i)
        r[i] = std::sin(1. + i);
      Vector<double> trailing = solver.condense(r);
      solver.interface_stiffness().solve_transposed_factor(trailing);
      solver.expand(trailing, u);
      system.matrix.vmult(image, u);
      for (unsigned int i = 0; i < n; ++i)
        if (is_fixed[i])
          BOOST_TEST(u[i] == 0.);
        else
          BOOST_TEST(std::abs(image[i] - r[i]) < 1e-11);

      // With any interface displacement the interior is in balance.
      for (auto &value : trailing)
        value += 0.3;
      solver.condense(r);
      solver.expand(trailing, u);
      system.matrix.vmult(image, u);
      for (const unsigned int i : interior)
        BOOST_TEST(std::abs(image[i] - r[i]) < 1e-11);
      for (unsigned int c = 0; c < interface.size(); ++c)
        BOOST_TEST(std::abs(u[interface[c]] - trailing[c]) < 1e-12);
    }
}



// A second factorisation on the same pattern replaces the first.
BOOST_AUTO_TEST_CASE(factorises_again)
{
  std::mt19937      random(11);
  System            system(40, random);
  std::vector<bool> is_fixed(40);
  SparseCholesky    cholesky;
  cholesky.analyse(system.pattern, is_fixed, {});
  Vector<double> b(40), x(40), image(40);
  b = 1.;
  for (const double factor : {1., 5.})
    {
      system.matrix *= factor;
      cholesky.factorise(system.matrix);
      cholesky.solve(x, b);
      system.matrix.vmult(image, x);
      image -= b;
      BOOST_TEST(image.linfty_norm() < 1e-12);
    }
}



BOOST_AUTO_TEST_CASE(names_the_pivot_that_fails)
{
  std::mt19937      random(3);
  System            system(20, random);
  std::vector<bool> is_fixed(20);
  system.matrix.set(13, 13, -1.);
  SparseCholesky cholesky;
  cholesky.analyse(system.pattern, is_fixed, {13});
  try
    {
      cholesky.factorise(system.matrix);
      BOOST_TEST(false);
    }
  catch (const NotPositiveDefinite &error)
    {
      BOOST_TEST(error.unknown == 13u);
    }
}

BOOST_AUTO_TEST_SUITE_END()
