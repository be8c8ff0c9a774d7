#ifndef signorini_linear_algebra_cholesky_condensation_h
#define signorini_linear_algebra_cholesky_condensation_h

#include <signorini/linear_algebra/condensed_solver.h>
#include <signorini/linear_algebra/sparse_cholesky.h>

namespace Signorini
{
  /**
   * Condensation as a by-product of one sparse Cholesky factorisation with the
   * interface ordered last (doc/theory.md). One forward and one
   * backward substitution a right-hand side, and nothing else.
   */
  class CholeskyCondensation : public CondensedSolver
  {
  public:
    void
    prepare(const dealii::SparsityPattern   &pattern,
            const std::vector<bool>         &is_fixed,
            const std::vector<unsigned int> &interface) override;

    void
    factorise(const dealii::SparseMatrix<double> &matrix) override;

    InterfaceStiffness
    interface_stiffness() const override;

    dealii::Vector<double>
    condense(const dealii::Vector<double> &residual) override;

    void
    expand(const dealii::Vector<double> &interface_displacement,
           dealii::Vector<double>       &displacement) override;

    const SparseCholesky &
    factorisation() const
    {
      return cholesky_;
    }

  private:
    SparseCholesky         cholesky_;
    unsigned int           n_interface_ = 0;
    InterfaceStiffness     trailing_;      // for expand()
    dealii::Vector<double> half_solution_; // L^-1 P r
  };
} // namespace Signorini

#endif
