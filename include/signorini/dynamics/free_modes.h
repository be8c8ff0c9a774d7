#ifndef signorini_dynamics_free_modes_h
#define signorini_dynamics_free_modes_h

#include <signorini/linear_algebra/types.h>
#include <signorini/solid/dof_map.h>
#include <signorini/variational_inequality/interface_types.h>
#include <signorini/variational_inequality/sparse_row.h>

#include <vector>

namespace Signorini
{
  /**
   * The motions of a static body as a whole that its supports leave free, seen
   * from the condensed interface: there its stiffness is singular.
   *
   * Three things are done about it. A statically determinate set of unknowns,
   * the pins, is held by springs while the sparse matrix is factorised; they
   * belong to the interface, on which the springs are taken out again exactly.
   * Closed contacts hold the motions in the interface problem. What these do
   * not hold gets springs, against these motions only, that vanish as the
   * iteration converges (proximal point method [Rockafellar1976]).
   */
  class FreeModes
  {
  public:
    FreeModes() = default;

    /**
     * @param modes over the unknowns of the interface: independent, the
     * largest entry of each about one
     * @param stiffnesses of what moves, against a motion of single nodes, one
     * a mode, N/m
     */
    FreeModes(const std::vector<InterfaceVector> &modes,
              const std::vector<double>          &stiffnesses);

    bool
    empty() const
    {
      return modes_.empty();
    }

    /**
     * As many unknowns as modes, so that to hold them holds all modes: those
     * of the largest pivots of an elimination.
     * @param dof_map those that it constrains will not do
     */
    static std::vector<unsigned int>
    pins(std::vector<DofVector> modes, const DofMap &dof_map);

    /** A spring k q q^T, with k in N/m and q over the interface, 1. */
    struct Spring
    {
      SparseRow row;
      double    stiffness; // N/m
    };

    /**
     * Springs against the motions that @p held leaves free, or holds so weakly
     * that the stiffness of what moves would drown it in rounding.
     */
    std::vector<Spring>
    springs(const std::vector<Spring> &held) const;

  private:
    // Scaled for springs of 1 N/m: d_i . m_j = 1 if i = j, else 0.
    std::vector<InterfaceVector> modes_;
    std::vector<InterfaceVector> duals_;
  };
} // namespace Signorini

#endif
