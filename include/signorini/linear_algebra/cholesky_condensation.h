#ifndef signorini_linear_algebra_cholesky_condensation_h
#define signorini_linear_algebra_cholesky_condensation_h

#include <signorini/linear_algebra/condensed_solver.h>
#include <signorini/linear_algebra/sparse_cholesky.h>
#include <signorini/linear_algebra/types.h>
#include <signorini/variational_inequality/interface_types.h>

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
    factorise(const DofMatrix &matrix) override;

    InterfaceStiffness
    interface_stiffness() const override;

    InterfaceVector
    condense(const DofVector &residual) override;

    void
    expand(const InterfaceVector &interface_displacement,
           DofVector             &displacement) override;

    const SparseCholesky &
    factorisation() const
    {
      return cholesky_;
    }

  private:
    SparseCholesky     cholesky_;
    unsigned int       n_interface_ = 0;
    InterfaceStiffness trailing_;      // for expand()
    DofVector          half_solution_; // L^-1 P r
  };
} // namespace Signorini

#endif
