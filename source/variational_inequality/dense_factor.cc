#include <signorini/variational_inequality/dense_factor.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <cmath>

#include "blas.h"

namespace Signorini
{
  namespace
  {
    // Of a matrix with entries of the order of one: a pivot that is rounding,
    // and what is then added to the diagonal. The latter is far above rounding,
    // so that the direction without resistance stays calm, and far below what
    // counts, so that two or three corrections remove its effect.
    constexpr double smallest_pivot = 1e-13;
    constexpr double regularisation = 1e-9;

    // Rows beyond this share of all cost as much as a factorisation.
    constexpr unsigned int least_rows_per_replaced_row = 8;

    // Of the capacitance, relative: what one correction can make good for.
    constexpr double smallest_capacitance = 1e-7;

    // False if a pivot is smaller than @p smallest.
    bool
    decompose(const unsigned int          n,
              const double                smallest,
              std::vector<double>        &matrix,
              std::vector<Blas::Integer> &pivots)
    {
      const Blas::Integer size = n;
      Blas::Integer       info = 0;
      pivots.resize(n);
      if (n > 0)
        Blas::dgetrf_(&size, &size, matrix.data(), &size, pivots.data(), &info);
      if (info != 0)
        return false;
      for (unsigned int i = 0; i < n; ++i)
        if (!(std::abs(matrix[i + std::size_t(i) * n]) > smallest))
          return false;
      return true;
    }

    double
    product(const unsigned int n, const double *x, const double *y)
    {
      const Blas::Integer size = n, one = 1;
      return Blas::ddot_(&size, x, &one, y, &one);
    }

    // Matrices are written by rows, which are columns to LAPACK.
    void
    substitute(const std::vector<double>        &lu,
               const std::vector<Blas::Integer> &pivots,
               std::vector<double>              &x)
    {
      const Blas::Integer size = x.size(), one = 1;
      Blas::Integer       info = 0;
      if (size > 0)
        Blas::dgetrs_("T",
                      &size,
                      &one,
                      lu.data(),
                      &size,
                      pivots.data(),
                      x.data(),
                      &size,
                      &info);
    }
  } // namespace



  void
  DenseFactor::clear()
  {
    known = false;
    row_keys.clear();
    replaced.clear();
    inverse_columns.clear();
  }



  void
  DenseFactor::settle()
  {
    is_settled = true;
  }



  bool
  DenseFactor::prepare(const unsigned int         size,
                       const std::vector<RowKey> &keys,
                       const RowWriter           &write_row)
  {
    Assert(keys.empty() || keys.size() == size,
           dealii::ExcDimensionMismatch(keys.size(), size));
    if (known && !keys.empty() && size == n)
      {
        std::vector<unsigned int> changed;
        for (unsigned int i = 0; i < n; ++i)
          if (keys[i] != row_keys[i])
            changed.push_back(i);
        const bool is_new = is_settled;
        is_settled        = false;
        if (changed.empty() || (!is_new && replace(changed, write_row)))
          {
            replaced = std::move(changed);
            return true;
          }
      }

    clear();
    n          = size;
    is_settled = false;
    if (!factorise(write_row))
      return false;
    known    = !keys.empty();
    row_keys = keys;
    return true;
  }



  bool
  DenseFactor::factorise(const RowWriter &write_row)
  {
    std::vector<double> matrix(std::size_t(n) * n);
    for (unsigned int i = 0; i < n; ++i)
      write_row(i, matrix.data() + std::size_t(i) * n);
    regularised = false;
    lu          = matrix;
    if (decompose(n, smallest_pivot, lu, pivots))
      return true;

    for (unsigned int i = 0; i < n; ++i)
      matrix[i + std::size_t(i) * n] += regularisation;
    lu          = std::move(matrix);
    regularised = true;
    return decompose(n, smallest_pivot, lu, pivots);
  }



  const std::vector<double> &
  DenseFactor::inverse_column(const unsigned int i)
  {
    std::vector<double> &column = inverse_columns[i];
    if (column.empty())
      {
        column.resize(n, 0.);
        column[i] = 1.;
        substitute(lu, pivots, column);
      }
    return column;
  }



  bool
  DenseFactor::replace(const std::vector<unsigned int> &rows,
                       const RowWriter                 &write_row)
  {
    const unsigned int m = rows.size();
    if (regularised || least_rows_per_replaced_row * m > n)
      return false;
    new_rows.resize(std::size_t(m) * n);
    for (unsigned int a = 0; a < m; ++a)
      write_row(rows[a], new_rows.data() + std::size_t(a) * n);
    capacitance.resize(std::size_t(m) * m);
    for (unsigned int b = 0; b < m; ++b)
      {
        const std::vector<double> &column = inverse_column(rows[b]);
        for (unsigned int a = 0; a < m; ++a)
          capacitance[b + std::size_t(a) * m] =
            product(n, new_rows.data() + std::size_t(a) * n, column.data());
      }
    double largest = 0.;
    for (const double entry : capacitance)
      largest = std::max(largest, std::abs(entry));
    return decompose(m,
                     smallest_capacitance * largest,
                     capacitance,
                     capacitance_pivots);
  }



  void
  DenseFactor::solve(std::vector<double> &x) const
  {
    AssertDimension(x.size(), n);
    if (replaced.empty())
      {
        substitute(lu, pivots, x);
        return;
      }
    const unsigned int  m = replaced.size();
    std::vector<double> missing(m);
    for (unsigned int a = 0; a < m; ++a)
      {
        missing[a]     = x[replaced[a]];
        x[replaced[a]] = 0.;
      }
    substitute(lu, pivots, x);
    for (unsigned int a = 0; a < m; ++a)
      missing[a] -= product(n, new_rows.data() + std::size_t(a) * n, x.data());
    substitute(capacitance, capacitance_pivots, missing);
    for (unsigned int b = 0; b < m; ++b)
      {
        const std::vector<double> &column = inverse_columns.at(replaced[b]);
        for (unsigned int i = 0; i < n; ++i)
          x[i] += missing[b] * column[i];
      }
  }
} // namespace Signorini
