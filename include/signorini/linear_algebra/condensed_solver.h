#ifndef signorini_linear_algebra_condensed_solver_h
#define signorini_linear_algebra_condensed_solver_h

#include <signorini/linear_algebra/types.h>
#include <signorini/variational_inequality/interface_stiffness.h>
#include <signorini/variational_inequality/interface_types.h>

#include <vector>

namespace Signorini
{
  /**
   * Solves K du = r - A^T lambda where lambda acts on few interface unknowns
   * only and is found by somebody else: the interior is condensed out, the
   * small problem S du_c = r_c - A^T lambda is handed over, and its solution is
   * expanded again. Other ways of solving stand behind the same interface.
   */
  class CondensedSolver
  {
  public:
    virtual ~CondensedSolver() = default;

    /**
     * @param pattern   of K, for all unknowns; must outlive the object
     * @param is_fixed  unknowns whose du is zero
     * @param interface free unknowns of the interface, in the order in which
     *                  the small problem counts them
     */
    virtual void
    prepare(const dealii::SparsityPattern   &pattern,
            const std::vector<bool>         &is_fixed,
            const std::vector<unsigned int> &interface) = 0;

    /** @throws NotPositiveDefinite, ComputationError. */
    virtual void
    factorise(const DofMatrix &matrix) = 0;

    /** The Schur complement S = K_cc - K_ci K_ii^-1 K_ic = L L^T. */
    virtual InterfaceStiffness
    interface_stiffness() const = 0;

    /**
     * Takes a residual r over all unknowns and returns L^-1 of its condensed
     * part r_c - K_ci K_ii^-1 r_i. The next expand() belongs to it.
     */
    virtual InterfaceVector
    condense(const DofVector &residual) = 0;

    /** du over all unknowns, from the interface part du_c. */
    virtual void
    expand(const InterfaceVector &interface_displacement,
           DofVector             &displacement) = 0;
  };
} // namespace Signorini

#endif
