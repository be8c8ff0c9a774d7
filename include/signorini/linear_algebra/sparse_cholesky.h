#ifndef signorini_linear_algebra_sparse_cholesky_h
#define signorini_linear_algebra_sparse_cholesky_h

#include <signorini/linear_algebra/types.h>

#include <deal.II/lac/sparsity_pattern.h>

#include <memory>
#include <vector>

namespace Signorini
{
  /**
   * The supernodal factorisation K = L L^T of CHOLMOD, of the rows and columns
   * that are free, in an order of our own: the interior unknowns by nested
   * dissection, then a chosen set of trailing unknowns. The trailing block of L
   * is then the Cholesky factor of the Schur complement on the trailing
   * unknowns (doc/theory.md).
   */
  class SparseCholesky
  {
  public:
    SparseCholesky();
    ~SparseCholesky();

    SparseCholesky(const SparseCholesky &) = delete;
    SparseCholesky &
    operator=(const SparseCholesky &) = delete;

    /**
     * Chooses the order and prepares the factor for matrices on this pattern.
     * The pattern must outlive the object.
     *
     * @param pattern  symmetric, square, of all unknowns
     * @param is_fixed unknowns that are left out (size: rows of the pattern)
     * @param trailing free unknowns to put last, in this order
     */
    void
    analyse(const dealii::SparsityPattern   &pattern,
            const std::vector<bool>         &is_fixed,
            const std::vector<unsigned int> &trailing);

    /**
     * Factorises a matrix on the analysed pattern. May be called again and
     * again. @throws NotPositiveDefinite.
     */
    void
    factorise(const DofMatrix &matrix);

    /** The unknowns in the order of the factor (free ones only). */
    const std::vector<unsigned int> &
    order() const;

    /** x <- L^-1 x, for x in the order of the factor. */
    void
    forward_substitution(DofVector &x) const;

    /** x <- L^-T x, for x in the order of the factor. */
    void
    backward_substitution(DofVector &x) const;

    /** x <- K^-1 b for vectors over all unknowns; fixed ones get zero. */
    void
    solve(DofVector &x, const DofVector &b) const;

    /**
     * The lower triangular block of L that belongs to the trailing unknowns,
     * n x n numbers by columns.
     */
    std::vector<double>
    trailing_factor() const;

    /** Number of entries of L, for estimates of cost. */
    double
    n_factor_entries() const;

  private:
    struct Implementation;
    std::unique_ptr<Implementation> implementation_;
  };

  /** Thrown when a pivot is not positive; names the unknown it belongs to. */
  class NotPositiveDefinite : public std::exception
  {
  public:
    explicit NotPositiveDefinite(const unsigned int unknown)
      : unknown(unknown)
    {}

    const char *
    what() const noexcept override
    {
      return "The stiffness matrix is not positive definite.";
    }

    const unsigned int unknown;
  };
} // namespace Signorini

#endif
