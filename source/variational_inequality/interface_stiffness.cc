#include <signorini/input_error.h>
#include <signorini/variational_inequality/interface_stiffness.h>

#include "blas.h"

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    [[noreturn]] void
    not_positive_definite(const unsigned int row)
    {
      throw ComputationError(
        "Interface stiffness: not positive definite (found at its row " +
        std::to_string(row) +
        "). A body may be free to move as a whole, or the material lost its "
        "stiffness; a smaller step helps against the latter.");
    }

    // OpenBLAS wakes its threads for a triangular product from n = 100 on,
    // though not for a triangular solve. Up to this size a product by columns
    // is faster.
    constexpr unsigned int largest_by_columns = 400;

    const Blas::Integer one = 1;

    // x <- L x. From the last column on, so that x_j is read before it changes.
    void
    multiply_by_columns(const std::vector<double> &lower, Vector<double> &x)
    {
      const Blas::Integer n = x.size();
      for (Blas::Integer j = n - 1; j >= 0; --j)
        {
          const double *const column = lower.data() + j + std::size_t(j) * n;
          const Blas::Integer below  = n - j - 1;
          const double        factor = x(j);
          x(j) *= *column;
          if (below > 0)
            Blas::daxpy_(
              &below, &factor, column + 1, &one, x.begin() + j + 1, &one);
        }
    }

    // x <- L^T x.
    void
    multiply_transposed_by_columns(const std::vector<double> &lower,
                                   Vector<double>            &x)
    {
      const Blas::Integer n = x.size();
      for (Blas::Integer i = 0; i < n; ++i)
        {
          const Blas::Integer length = n - i;
          x(i)                       = Blas::ddot_(&length,
                             lower.data() + i + std::size_t(i) * n,
                             &one,
                             x.begin() + i,
                             &one);
        }
    }

    using TriangularKernel = decltype(Blas::dtrsv_);

    // Both BLAS kernels on a vector differ by their name only.
    void
    run_kernel(TriangularKernel          *kernel,
               const char                 transposition,
               const std::vector<double> &lower,
               Vector<double>            &x)
    {
      const Blas::Integer n = x.size();
      AssertDimension(lower.size(), x.size() * x.size());
      if (n > 0)
        kernel("L", &transposition, "N", &n, lower.data(), &n, x.data(), &one);
    }
  } // namespace



  InterfaceStiffness
  InterfaceStiffness::from_cholesky_factor(const unsigned int    size,
                                           std::vector<double> &&lower_factor)
  {
    AssertDimension(lower_factor.size(), std::size_t(size) * size);
    for (unsigned int i = 0; i < size; ++i)
      if (!(lower_factor[i + std::size_t(i) * size] > 0.))
        not_positive_definite(i);
    InterfaceStiffness stiffness;
    stiffness.n     = size;
    stiffness.lower = std::move(lower_factor);
    return stiffness;
  }



  InterfaceStiffness
  InterfaceStiffness::from_matrix(const FullMatrix<double> &matrix)
  {
    AssertDimension(matrix.m(), matrix.n());
    const Blas::Integer n = matrix.m();
    InterfaceStiffness  stiffness;
    stiffness.n = n;
    stiffness.lower.resize(std::size_t(n) * n);
    for (Blas::Integer i = 0; i < n; ++i)
      for (Blas::Integer j = 0; j <= i; ++j)
        stiffness.lower[i + std::size_t(j) * n] = matrix(i, j);
    Blas::Integer info = 0;
    if (n > 0)
      Blas::dpotrf_("L", &n, stiffness.lower.data(), &n, &info);
    if (info > 0)
      not_positive_definite(info - 1);
    return stiffness;
  }



  void
  InterfaceStiffness::multiply(Vector<double> &x) const
  {
    multiply_transposed_factor(x);
    multiply_factor(x);
  }



  void
  InterfaceStiffness::multiply_absolute(Vector<double> &x) const
  {
    AssertDimension(x.size(), n);
    Vector<double> product(n);
    for (unsigned int j = 0; j < n; ++j)
      {
        const double *const column = lower.data() + std::size_t(j) * n;
        double              sum    = 0.;
        for (unsigned int i = j; i < n; ++i)
          sum += std::abs(column[i] * x(i));
        for (unsigned int i = j; i < n; ++i)
          product(i) += std::abs(column[i]) * sum;
      }
    x = product;
  }



  void
  InterfaceStiffness::solve(Vector<double> &x) const
  {
    solve_factor(x);
    solve_transposed_factor(x);
  }



  void
  InterfaceStiffness::solve_columns(std::vector<double> &columns,
                                    const unsigned int   n_columns) const
  {
    AssertDimension(columns.size(), std::size_t(n) * n_columns);
    if (columns.empty())
      return;
    const Blas::Integer rows = n, count = n_columns;
    const double        unit = 1.;
    for (const char *const transposition : {"N", "T"})
      Blas::dtrsm_("L",
                   "L",
                   transposition,
                   "N",
                   &rows,
                   &count,
                   &unit,
                   lower.data(),
                   &rows,
                   columns.data(),
                   &rows);
  }



  void
  InterfaceStiffness::multiply_factor(Vector<double> &x) const
  {
    AssertDimension(x.size(), n);
    if (n <= largest_by_columns)
      multiply_by_columns(lower, x);
    else
      run_kernel(Blas::dtrmv_, 'N', lower, x);
  }



  void
  InterfaceStiffness::multiply_transposed_factor(Vector<double> &x) const
  {
    AssertDimension(x.size(), n);
    if (n <= largest_by_columns)
      multiply_transposed_by_columns(lower, x);
    else
      run_kernel(Blas::dtrmv_, 'T', lower, x);
  }



  void
  InterfaceStiffness::solve_factor(Vector<double> &x) const
  {
    run_kernel(Blas::dtrsv_, 'N', lower, x);
  }



  void
  InterfaceStiffness::solve_transposed_factor(Vector<double> &x) const
  {
    run_kernel(Blas::dtrsv_, 'T', lower, x);
  }



  double
  InterfaceStiffness::smallest_pivot() const
  {
    std::vector<double> diagonal(n);
    for (unsigned int j = 0; j < n; ++j)
      for (unsigned int i = j; i < n; ++i)
        diagonal[i] += factor(i, j) * factor(i, j);
    double smallest = 1.;
    for (unsigned int i = 0; i < n; ++i)
      smallest = std::min(smallest, factor(i, i) * factor(i, i) / diagonal[i]);
    return smallest;
  }



  FullMatrix<double>
  InterfaceStiffness::matrix() const
  {
    // 1. L with zeros above the diagonal, which then becomes L L^T.
    std::vector<double> product(lower.size());
    for (unsigned int j = 0; j < n; ++j)
      for (unsigned int i = j; i < n; ++i)
        product[i + std::size_t(j) * n] = factor(i, j);
    const Blas::Integer size = n;
    const double        unit = 1.;
    if (n > 0)
      Blas::dtrmm_("R",
                   "L",
                   "T",
                   "N",
                   &size,
                   &size,
                   &unit,
                   lower.data(),
                   &size,
                   product.data(),
                   &size);

    // 2. Exactly symmetric, from the lower triangle.
    FullMatrix<double> matrix(n, n);
    for (unsigned int j = 0; j < n; ++j)
      for (unsigned int i = j; i < n; ++i)
        matrix(i, j) = matrix(j, i) = product[i + std::size_t(j) * n];
    return matrix;
  }
} // namespace Signorini
