#ifndef signorini_variational_inequality_dense_factor_h
#define signorini_variational_inequality_dense_factor_h

#include <deal.II/lac/lapack_support.h>

#include <vector>

namespace Signorini
{
  /**
   * LU factors of a small, dense, unsymmetric matrix, together with a key that
   * says which matrix it was, so that it is not factorised twice. The diagonal
   * entries of the matrix should be of the order of one.
   *
   * If a pivot vanishes to rounding, a small multiple of the unit matrix is
   * added. For a consistent system the solution is then found by repeated
   * correction, and of several the one next to the start.
   */
  class DenseFactor
  {
  public:
    using Key = std::vector<double>;

    void
    clear();

    bool
    has_key(const Key &other) const
    {
      return known && key == other;
    }

    /** Factorises @p matrix, n * n numbers by columns. Without a @p new_key it
     * is not known by has_key().
     * @return false if it cannot be factorised. */
    bool
    factorise(const unsigned int n, std::vector<double> matrix, Key new_key);

    /** x <- M^-1 x. */
    void
    solve(std::vector<double> &x) const;

    /** Was the matrix singular to rounding? */
    bool
    is_regularised() const
    {
      return regularised;
    }

    unsigned int
    size() const
    {
      return n;
    }

  private:
    // False if a pivot is zero to rounding.
    bool
    decompose();

    bool                                 known       = false;
    bool                                 regularised = false;
    unsigned int                         n           = 0;
    Key                                  key;
    std::vector<double>                  lu;
    std::vector<dealii::types::blas_int> pivots;
  };
} // namespace Signorini

#endif
