#include <signorini/input/input_error.h>
#include <signorini/variational_inequality/interface_stiffness.h>

#include <algorithm>

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

    // The products of S are formed in blocks of so many columns: wide enough
    // for the speed of a full product, and narrow against n.
    constexpr Blas::Integer block_size = 128;

    // x <- L x. From the last column on, so that x_j is read before it changes.
    void
    multiply_by_columns(const double *lower, InterfaceVector &x)
    {
      const Blas::Integer n = x.size();
      for (Blas::Integer j = n - 1; j >= 0; --j)
        {
          const double *const column = lower + j + std::size_t(j) * n;
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
    multiply_transposed_by_columns(const double *lower, InterfaceVector &x)
    {
      const Blas::Integer n = x.size();
      for (Blas::Integer i = 0; i < n; ++i)
        {
          const Blas::Integer length = n - i;
          x(i)                       = Blas::ddot_(
            &length, lower + i + std::size_t(i) * n, &one, x.begin() + i, &one);
        }
    }

    using TriangularKernel = decltype(Blas::dtrsv_);

    // Both BLAS kernels on a vector differ by their name only.
    void
    run_kernel(TriangularKernel *kernel,
               const char        transposition,
               const double     *lower,
               InterfaceVector  &x)
    {
      const Blas::Integer n = x.size();
      if (n > 0)
        kernel("L", &transposition, "N", &n, lower, &n, x.data(), &one);
    }

    // The lower triangle of S = L L^T, by columns. Block column J is
    //   S_IJ = sum_(K < J) L_IK L_JK^T + L_IJ L_JJ^T for I >= J,
    // where only the last term has a triangle in it.
    void
    multiply_by_transpose(const Blas::Integer n,
                          const double       *lower,
                          double             *product)
    {
      const double unit = 1.;
      for (Blas::Integer j = 0; j < n; j += block_size)
        {
          const Blas::Integer width    = std::min(block_size, n - j);
          const Blas::Integer height   = n - j;
          const std::size_t   diagonal = j + std::size_t(j) * n;
          for (Blas::Integer column = 0; column < width; ++column)
            {
              const std::size_t start = diagonal + std::size_t(column) * n;
              std::fill_n(product + start, column, 0.);
              std::copy_n(lower + start + column,
                          height - column,
                          product + start + column);
            }
          Blas::dtrmm_("R",
                       "L",
                       "T",
                       "N",
                       &height,
                       &width,
                       &unit,
                       lower + diagonal,
                       &n,
                       product + diagonal,
                       &n);
          if (j > 0)
            Blas::dgemm_("N",
                         "T",
                         &height,
                         &width,
                         &j,
                         &unit,
                         lower + j,
                         &n,
                         lower + j,
                         &n,
                         &unit,
                         product + diagonal,
                         &n);
        }
    }

    // Makes both triangles alike, tile by tile so that the rows of the one and
    // the columns of the other stay in the cache.
    void
    copy_upper_to_lower(InterfaceMatrix &matrix)
    {
      const unsigned int n = matrix.m(), tile = 32;
      for (unsigned int i0 = 0; i0 < n; i0 += tile)
        for (unsigned int j0 = 0; j0 <= i0; j0 += tile)
          for (unsigned int i = i0; i < std::min(n, i0 + tile); ++i)
            for (unsigned int j = j0; j < std::min(i, j0 + tile); ++j)
              matrix(i, j) = matrix(j, i);
    }
  } // namespace



  InterfaceStiffness::InterfaceStiffness()
    : InterfaceStiffness(InterfaceMatrix())
  {}



  InterfaceStiffness::InterfaceStiffness(InterfaceMatrix &&transposed_factor)
    : parts(std::make_shared<Parts>())
  {
    parts->transposed_factor.swap(transposed_factor);
  }



  InterfaceStiffness
  InterfaceStiffness::from_cholesky_factor(
    const unsigned int         size,
    const std::vector<double> &lower_factor)
  {
    AssertDimension(lower_factor.size(), std::size_t(size) * size);
    for (unsigned int i = 0; i < size; ++i)
      if (!(lower_factor[i + std::size_t(i) * size] > 0.))
        not_positive_definite(i);
    if (size == 0)
      return InterfaceStiffness();
    return InterfaceStiffness(InterfaceMatrix(size, size, lower_factor.data()));
  }



  InterfaceStiffness
  InterfaceStiffness::from_matrix(InterfaceMatrix matrix)
  {
    AssertDimension(matrix.m(), matrix.n());
    // Symmetric, it is the same by rows and by columns.
    const Blas::Integer n    = matrix.m();
    Blas::Integer       info = 0;
    if (n > 0)
      Blas::dpotrf_("L", &n, &matrix(0, 0), &n, &info);
    if (info > 0)
      not_positive_definite(info - 1);
    return InterfaceStiffness(std::move(matrix));
  }



  const double *
  InterfaceStiffness::lower() const
  {
    return size() == 0 ? nullptr : &parts->transposed_factor(0, 0);
  }



  void
  InterfaceStiffness::multiply(InterfaceVector &x) const
  {
    multiply_transposed_factor(x);
    multiply_factor(x);
  }



  void
  InterfaceStiffness::multiply_absolute(InterfaceVector &x) const
  {
    AssertDimension(x.size(), size());
    const unsigned int n = size();
    InterfaceVector    product(n);
    for (unsigned int j = 0; j < n; ++j)
      {
        const double *const column = lower() + std::size_t(j) * n;
        double              sum    = 0.;
        for (unsigned int i = j; i < n; ++i)
          sum += std::abs(column[i] * x(i));
        for (unsigned int i = j; i < n; ++i)
          product(i) += std::abs(column[i]) * sum;
      }
    x = product;
  }



  void
  InterfaceStiffness::solve(InterfaceVector &x) const
  {
    solve_factor(x);
    solve_transposed_factor(x);
  }



  void
  InterfaceStiffness::solve_columns(std::vector<double> &columns,
                                    const unsigned int   n_columns) const
  {
    AssertDimension(columns.size(), std::size_t(size()) * n_columns);
    if (columns.empty())
      return;
    const Blas::Integer rows = size(), count = n_columns;
    const double        unit = 1.;
    for (const char *const transposition : {"N", "T"})
      Blas::dtrsm_("L",
                   "L",
                   transposition,
                   "N",
                   &rows,
                   &count,
                   &unit,
                   lower(),
                   &rows,
                   columns.data(),
                   &rows);
  }



  void
  InterfaceStiffness::multiply_factor(InterfaceVector &x) const
  {
    AssertDimension(x.size(), size());
    if (size() <= largest_by_columns)
      multiply_by_columns(lower(), x);
    else
      run_kernel(Blas::dtrmv_, 'N', lower(), x);
  }



  void
  InterfaceStiffness::multiply_transposed_factor(InterfaceVector &x) const
  {
    AssertDimension(x.size(), size());
    if (size() <= largest_by_columns)
      multiply_transposed_by_columns(lower(), x);
    else
      run_kernel(Blas::dtrmv_, 'T', lower(), x);
  }



  void
  InterfaceStiffness::solve_factor(InterfaceVector &x) const
  {
    run_kernel(Blas::dtrsv_, 'N', lower(), x);
  }



  void
  InterfaceStiffness::solve_transposed_factor(InterfaceVector &x) const
  {
    run_kernel(Blas::dtrsv_, 'T', lower(), x);
  }



  double
  InterfaceStiffness::smallest_pivot() const
  {
    const unsigned int  n = size();
    std::vector<double> diagonal(n);
    for (unsigned int j = 0; j < n; ++j)
      for (unsigned int i = j; i < n; ++i)
        diagonal[i] += factor(i, j) * factor(i, j);
    double smallest = 1.;
    for (unsigned int i = 0; i < n; ++i)
      smallest = std::min(smallest, factor(i, i) * factor(i, i) / diagonal[i]);
    return smallest;
  }



  const InterfaceMatrix &
  InterfaceStiffness::matrix() const
  {
    InterfaceMatrix &matrix = parts->matrix;
    if (matrix.m() != size())
      {
        matrix.reinit(size(), size());
        multiply_by_transpose(size(), lower(), &matrix(0, 0));
        copy_upper_to_lower(matrix);
      }
    return matrix;
  }
} // namespace Signorini
