#ifndef signorini_variational_inequality_interface_stiffness_h
#define signorini_variational_inequality_interface_stiffness_h


#include <signorini/variational_inequality/interface_types.h>

#include <memory>
#include <vector>

namespace Signorini
{
  /**
   * The stiffness of the condensed interface, S = L L^T: symmetric, positive
   * definite, dense, n x n, in N/m. Only the lower triangle of L is kept, by
   * columns. It never changes, so that copies share it, and no step pays for
   * n^2 numbers by accident.
   */
  class InterfaceStiffness
  {
  public:
    /** The empty stiffness, n = 0. */
    InterfaceStiffness();

    /**
     * From the factor L itself, e.g. the trailing block of a sparse
     * factorisation. @p lower_factor holds n * n numbers by columns,
     * L(i, j) = lower_factor[i + j * n]; what stands above the diagonal is
     * not read.
     * @throws ComputationError if a diagonal entry of L is not positive.
     */
    static InterfaceStiffness
    from_cholesky_factor(const unsigned int         size,
                         const std::vector<double> &lower_factor);

    /**
     * Factorises a symmetric matrix in its own place: move it here, and no
     * second one is made.
     * @throws ComputationError if it is not positive definite.
     */
    static InterfaceStiffness
    from_matrix(InterfaceMatrix matrix);

    unsigned int
    size() const
    {
      return parts->transposed_factor.m();
    }

    /** x <- S x. */
    void
    multiply(InterfaceVector &x) const;

    /** x <- |L| |L^T| |x|: times the machine precision the size of the rounding
     * in S x, and in S^-1 times a force [Higham2002, theorem 10.4]. */
    void
    multiply_absolute(InterfaceVector &x) const;

    /** x <- S^-1 x. */
    void
    solve(InterfaceVector &x) const;

    /** B <- S^-1 B for n x @p n_columns numbers, stored by columns. */
    void
    solve_columns(std::vector<double> &columns,
                  const unsigned int   n_columns) const;

    /** x <- L x. */
    void
    multiply_factor(InterfaceVector &x) const;

    /** x <- L^T x: what takes the place of the condensed force before the
     * backward substitution of the sparse factor. */
    void
    multiply_transposed_factor(InterfaceVector &x) const;

    /** x <- L^-1 x. */
    void
    solve_factor(InterfaceVector &x) const;

    /** x <- L^-T x. */
    void
    solve_transposed_factor(InterfaceVector &x) const;

    /** L(i, j) for j <= i. */
    double
    factor(const unsigned int i, const unsigned int j) const
    {
      Assert(j <= i && i < size(), dealii::ExcIndexRange(j, 0, i + 1));
      return parts->transposed_factor(j, i);
    }

    /** The smallest of L_ii^2/S_ii: what the rows before leave of a diagonal
     * entry. Small if S is nearly singular, whatever its units. 1 if n = 0. */
    double
    smallest_pivot() const;

    /**
     * S itself: n^3/3 multiplications when it is first asked for, of this
     * object or of one that it shares L with; then it is kept. Not safe to
     * share between threads.
     */
    const InterfaceMatrix &
    matrix() const;

  private:
    // By rows L^T, which is L by columns; and S, empty until it is asked for.
    struct Parts
    {
      InterfaceMatrix transposed_factor;
      InterfaceMatrix matrix;
    };

    explicit InterfaceStiffness(InterfaceMatrix &&transposed_factor);

    // L(0, 0), by columns.
    const double *
    lower() const;

    std::shared_ptr<Parts> parts;
  };
} // namespace Signorini

#endif
