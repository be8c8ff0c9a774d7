#ifndef signorini_variational_inequality_semidefinite_cholesky_h
#define signorini_variational_inequality_semidefinite_cholesky_h


#include <signorini/variational_inequality/interface_types.h>

#include <vector>

namespace Signorini
{
  /**
   * Cholesky factor, with complete pivoting unless B is clearly definite, of a
   * principal block B = W_FF of a symmetric positive semidefinite matrix,
   * scaled to a unit diagonal so that the rank does not depend on units. The
   * rows of F fall into `rank()' independent ones and the `dependent()' rest.
   */
  class SemidefiniteCholesky
  {
  public:
    /** @param indices F, without repetitions. */
    SemidefiniteCholesky(const InterfaceMatrix           &matrix,
                         const std::vector<unsigned int> &indices);

    unsigned int
    size() const
    {
      return n;
    }

    unsigned int
    rank() const
    {
      return independent_rows;
    }

    /** Positions within F of the rows that depend on the others. */
    std::vector<unsigned int>
    dependent() const;

    /** p with (B p - b) = 0 in the independent rows and p = 0 in the others. If
     * b is in the range of B, B p = b. */
    std::vector<double>
    solve(const std::vector<double> &right_hand_side) const;

    /** z with B z = 0 that equals a positive multiple of @p remainder in the
     * dependent rows, up to the scaling: z^T remainder > 0 unless the remainder
     * vanishes there. Its other entries are not read. */
    std::vector<double>
    null_direction(const std::vector<double> &remainder) const;

  private:
    // False, and nothing changed, unless all pivots are clear of rounding.
    bool
    factorise_definite();

    // op(L_11)^-1 on the first rank() entries.
    void
    solve_triangular(const char           transposition,
                     std::vector<double> &pivoted) const;

    double
    factor(const unsigned int i, const unsigned int j) const
    {
      return lower[i + std::size_t(j) * n];
    }

    unsigned int              n;
    unsigned int              independent_rows;
    std::vector<double>       scaling; // by position: 1 / sqrt(B_ii)
    std::vector<unsigned int> pivots;  // position of each row of the factor
    std::vector<double>       lower;   // by columns
  };
} // namespace Signorini

#endif
