#include <signorini/variational_inequality/semidefinite_cholesky.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "blas.h"

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    // Relative to a unit diagonal: below this a pivot is rounding error.
    double
    rank_tolerance(const unsigned int n)
    {
      return 4. * std::max(n, 8U) * std::numeric_limits<double>::epsilon();
    }

    // Relative to a unit diagonal: all pivots above this leave no doubt.
    constexpr double definite_pivot = 1e-8;
  } // namespace



  SemidefiniteCholesky::SemidefiniteCholesky(
    const InterfaceMatrix           &matrix,
    const std::vector<unsigned int> &indices)
    : n(indices.size())
    , independent_rows(0)
    , scaling(n, 1.)
    , pivots(n)
    , lower(std::size_t(n) * n)
  {
    // 1. Scale to a unit diagonal. A row without one is zero: by
    // semidefiniteness the rest of it is, too.
    for (unsigned int i = 0; i < n; ++i)
      {
        const double diagonal = matrix(indices[i], indices[i]);
        if (diagonal > 0.)
          scaling[i] = 1. / std::sqrt(diagonal);
        for (unsigned int j = 0; j <= i; ++j)
          lower[i + std::size_t(j) * n] =
            scaling[i] * scaling[j] * matrix(indices[i], indices[j]);
      }

    if (n == 0 || factorise_definite())
      return;

    // 3. Factorise until the largest pivot left is rounding error.
    const Blas::Integer        size      = n;
    const double               tolerance = rank_tolerance(n);
    std::vector<Blas::Integer> order(n);
    std::vector<double>        work(2 * n);
    Blas::Integer              rank = 0, info = 0;
    Blas::dpstrf_("L",
                  &size,
                  lower.data(),
                  &size,
                  order.data(),
                  &rank,
                  &tolerance,
                  work.data(),
                  &info);
    // LAPACK leaves the order unset if it stops at the first pivot.
    for (unsigned int i = 0; i < n; ++i)
      pivots[i] = rank > 0 ? order[i] - 1 : i;
    independent_rows = rank;
  }



  bool
  SemidefiniteCholesky::factorise_definite()
  {
    // 2. Without pivoting, which is several times faster; a pivot that is far
    // above rounding throughout shows that it was not needed.
    const Blas::Integer size   = n;
    Blas::Integer       info   = 0;
    std::vector<double> factor = lower;
    Blas::dpotrf_("L", &size, factor.data(), &size, &info);
    if (info != 0)
      return false;
    for (unsigned int i = 0; i < n; ++i)
      {
        const double diagonal = factor[i + std::size_t(i) * n];
        if (!(diagonal * diagonal > definite_pivot))
          return false;
        pivots[i] = i;
      }
    lower            = std::move(factor);
    independent_rows = n;
    return true;
  }



  std::vector<unsigned int>
  SemidefiniteCholesky::dependent() const
  {
    return {pivots.begin() + rank(), pivots.end()};
  }



  void
  SemidefiniteCholesky::solve_triangular(const char           transposition,
                                         std::vector<double> &pivoted) const
  {
    const Blas::Integer size = n, leading = rank(), one = 1;
    if (leading > 0)
      Blas::dtrsv_("L",
                   &transposition,
                   "N",
                   &leading,
                   lower.data(),
                   &size,
                   pivoted.data(),
                   &one);
  }



  std::vector<double>
  SemidefiniteCholesky::solve(const std::vector<double> &right_hand_side) const
  {
    AssertDimension(right_hand_side.size(), n);
    std::vector<double> pivoted(rank());
    for (unsigned int i = 0; i < rank(); ++i)
      pivoted[i] = scaling[pivots[i]] * right_hand_side[pivots[i]];
    solve_triangular('N', pivoted);
    solve_triangular('T', pivoted);

    std::vector<double> solution(n, 0.);
    for (unsigned int i = 0; i < rank(); ++i)
      solution[pivots[i]] = scaling[pivots[i]] * pivoted[i];
    return solution;
  }



  std::vector<double>
  SemidefiniteCholesky::null_direction(
    const std::vector<double> &remainder) const
  {
    AssertDimension(remainder.size(), n);
    // z = (-L_11^-T L_21^T v, v), v the scaled remainder.
    std::vector<double> pivoted(n, 0.);
    for (unsigned int i = rank(); i < n; ++i)
      {
        pivoted[i] = scaling[pivots[i]] * remainder[pivots[i]];
        for (unsigned int j = 0; j < rank(); ++j)
          pivoted[j] -= factor(i, j) * pivoted[i];
      }
    solve_triangular('T', pivoted);

    // Rounding must not look like an entry that decreases towards a bound.
    double largest = 0.;
    for (const double entry : pivoted)
      largest = std::max(largest, std::abs(entry));
    std::vector<double> direction(n, 0.);
    for (unsigned int i = 0; i < n; ++i)
      if (std::abs(pivoted[i]) > rank_tolerance(n) * largest)
        direction[pivots[i]] = scaling[pivots[i]] * pivoted[i];
    return direction;
  }
} // namespace Signorini
