#ifndef signorini_variational_inequality_interface_stiffness_h
#define signorini_variational_inequality_interface_stiffness_h

#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/vector.h>

#include <vector>

namespace Signorini
{
  /**
   * The stiffness of the condensed interface, S = L L^T: symmetric, positive
   * definite, dense, n x n, in N/m. Only the lower triangle of L is kept, by
   * columns. Can be moved, not copied, so that no step pays for n^2 numbers
   * by accident.
   */
  class InterfaceStiffness
  {
  public:
    /** The empty stiffness, n = 0. */
    InterfaceStiffness() = default;

    InterfaceStiffness(InterfaceStiffness &&) = default;
    InterfaceStiffness &
    operator=(InterfaceStiffness &&)               = default;
    InterfaceStiffness(const InterfaceStiffness &) = delete;
    InterfaceStiffness &
    operator=(const InterfaceStiffness &) = delete;

    /**
     * From the factor L itself, e.g. the trailing block of a sparse
     * factorisation. @p lower_factor holds n * n numbers by columns,
     * L(i, j) = lower_factor[i + j * n]; what stands above the diagonal is
     * not read.
     * @throws ComputationError if a diagonal entry of L is not positive.
     */
    static InterfaceStiffness
    from_cholesky_factor(const unsigned int    size,
                         std::vector<double> &&lower_factor);

    /**
     * Factorises @p matrix, of which the lower triangle is read.
     * @throws ComputationError if it is not positive definite.
     */
    static InterfaceStiffness
    from_matrix(const dealii::FullMatrix<double> &matrix);

    unsigned int
    size() const
    {
      return n;
    }

    /** x <- S x. */
    void
    multiply(dealii::Vector<double> &x) const;

    /** x <- |L| |L^T| |x|: times the machine precision the size of the rounding
     * in S x, and in S^-1 times a force (Higham 2002, theorem 10.4). */
    void
    multiply_absolute(dealii::Vector<double> &x) const;

    /** x <- S^-1 x. */
    void
    solve(dealii::Vector<double> &x) const;

    /** B <- S^-1 B for n x @p n_columns numbers, stored by columns. */
    void
    solve_columns(std::vector<double> &columns,
                  const unsigned int   n_columns) const;

    /** x <- L x. */
    void
    multiply_factor(dealii::Vector<double> &x) const;

    /** x <- L^T x: what takes the place of the condensed force before the
     * backward substitution of the sparse factor. */
    void
    multiply_transposed_factor(dealii::Vector<double> &x) const;

    /** x <- L^-1 x. */
    void
    solve_factor(dealii::Vector<double> &x) const;

    /** x <- L^-T x. */
    void
    solve_transposed_factor(dealii::Vector<double> &x) const;

    /** L(i, j) for j <= i. */
    double
    factor(const unsigned int i, const unsigned int j) const
    {
      Assert(j <= i && i < n, dealii::ExcIndexRange(j, 0, i + 1));
      return lower[i + std::size_t(j) * n];
    }

    /** The smallest of L_ii^2/S_ii: what the rows before leave of a diagonal
     * entry. Small if S is nearly singular, whatever its units. 1 if n = 0. */
    double
    smallest_pivot() const;

    /** S itself, O(n^3): to add to it, or to look at it. */
    dealii::FullMatrix<double>
    matrix() const;

  private:
    unsigned int        n = 0;
    std::vector<double> lower;
  };
} // namespace Signorini

#endif
