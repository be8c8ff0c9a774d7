#ifndef signorini_variational_inequality_dense_factor_h
#define signorini_variational_inequality_dense_factor_h

#include <deal.II/lac/lapack_support.h>

#include <functional>
#include <map>
#include <utility>
#include <vector>

namespace Signorini
{
  /**
   * LU factors of a small, dense, unsymmetric matrix, whose rows have keys that
   * say what they are. A matrix that differs in a few rows is not factorised
   * anew: the solution moves along the columns of the inverse that belong to
   * these rows until they hold (Sherman, Morrison & Woodbury). The diagonal
   * entries of the matrix should be of the order of one.
   *
   * If a pivot vanishes to rounding, a small multiple of the unit matrix is
   * added. For a consistent system the solution is then found by repeated
   * correction, and of several the one next to the start.
   */
  class DenseFactor
  {
  public:
    using RowKey = std::pair<int, double>;

    /** Writes the entries of a row. */
    using RowWriter = std::function<void(const unsigned int, double *)>;

    void
    clear();

    /** Forgets replaced rows: unless the next matrix is the one that was
     * factorised, it is factorised. Results then do not depend, in their last
     * digits, on what was solved before. */
    void
    settle();

    /**
     * Factorises the matrix of @p n rows, or replaces the rows whose keys have
     * changed. Without @p keys it is factorised in any case.
     * @return false if it cannot be factorised.
     */
    bool
    prepare(const unsigned int         n,
            const std::vector<RowKey> &keys,
            const RowWriter           &write_row);

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

    unsigned int
    n_replaced_rows() const
    {
      return replaced.size();
    }

  private:
    using Pivots = std::vector<dealii::types::blas_int>;

    bool
    factorise(const RowWriter &write_row);

    // False if the rows make the matrix singular, or nearly so.
    bool
    replace(const std::vector<unsigned int> &rows, const RowWriter &write_row);

    // Column @p i of the inverse of the factorised matrix.
    const std::vector<double> &
    inverse_column(const unsigned int i);

    bool                known       = false;
    bool                is_settled  = true;
    bool                regularised = false;
    unsigned int        n           = 0;
    std::vector<RowKey> row_keys; // of the factorised matrix
    std::vector<double> lu;       // of the transposed matrix
    Pivots              pivots;

    // The rows that are not as factorised, and the LU factors of
    // (new rows) M^-1 (unit vectors of these rows).
    std::vector<unsigned int>                   replaced;
    std::vector<double>                         new_rows;
    std::vector<double>                         capacitance;
    Pivots                                      capacitance_pivots;
    std::map<unsigned int, std::vector<double>> inverse_columns;
  };
} // namespace Signorini

#endif
