#include <signorini/variational_inequality/dense_factor.h>

#include <deal.II/base/exceptions.h>

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
  } // namespace



  void
  DenseFactor::clear()
  {
    known = false;
    key.clear();
  }



  bool
  DenseFactor::factorise(const unsigned int  size,
                         std::vector<double> matrix,
                         Key                 new_key)
  {
    AssertDimension(matrix.size(), std::size_t(size) * size);
    n           = size;
    known       = !new_key.empty();
    key         = std::move(new_key);
    regularised = false;
    lu          = matrix;
    if (decompose())
      return true;

    for (unsigned int i = 0; i < n; ++i)
      matrix[i + std::size_t(i) * n] += regularisation;
    lu          = std::move(matrix);
    regularised = true;
    if (decompose())
      return true;
    clear();
    return false;
  }



  bool
  DenseFactor::decompose()
  {
    const Blas::Integer size = n;
    Blas::Integer       info = 0;
    pivots.resize(n);
    if (n > 0)
      Blas::dgetrf_(&size, &size, lu.data(), &size, pivots.data(), &info);
    if (info != 0)
      return false;
    for (unsigned int i = 0; i < n; ++i)
      if (!(std::abs(lu[i + std::size_t(i) * n]) > smallest_pivot))
        return false;
    return true;
  }



  void
  DenseFactor::solve(std::vector<double> &x) const
  {
    AssertDimension(x.size(), n);
    const Blas::Integer size = n, one = 1;
    Blas::Integer       info = 0;
    if (n > 0)
      Blas::dgetrs_("N",
                    &size,
                    &one,
                    lu.data(),
                    &size,
                    pivots.data(),
                    x.data(),
                    &size,
                    &info);
  }
} // namespace Signorini
