#ifndef signorini_solid_mass_redistribution_h
#define signorini_solid_mass_redistribution_h

#include <signorini/linear_algebra/types.h>
#include <signorini/solid/body.h>
#include <signorini/solid/dof_map.h>

#include <deal.II/lac/dynamic_sparsity_pattern.h>

#include <map>
#include <utility>
#include <vector>

namespace Signorini
{
  /**
   * Takes the inertia off nodes that come into contact [cf.
   * KhenousLabordeRenard2008; HagerHueberWohlmuth2008]. With m the lumped mass
   * of such a node c, what its row and column of the mass matrix M lose goes to
   * the diagonal of its nearest inner neighbours, so that the pattern of M
   * stays. What this changes in the moments of mass, keep_moments() mends.
   *
   * The velocity of a massless node is an extrapolation of inner nodes,
   * v_c = sum_j w_cj v_j or v <- P v, exact for affine fields such as a
   * rotation. Where inner nodes do not span the space it is their mean.
   * Dampings become P^T C P.
   */
  class MassRedistribution
  {
  public:
    /** (unknown, weight) */
    using Row = std::vector<std::pair<unsigned int, double>>;

    /**
     * Finds the weights of the contact nodes of a body.
     *
     * @param contact_nodes nodes that lose their mass
     * @param dof_map       its constrained unknowns keep their mass
     * @throws InputError when a body has too few inner nodes.
     */
    template <int dim>
    void
    add(const Body<dim>              &body,
        const std::vector<Node<dim>> &contact_nodes,
        const DofMap                 &dof_map);

    bool
    is_massless(const unsigned int dof) const
    {
      return rows_.count(dof) > 0;
    }

    bool
    empty() const
    {
      return rows_.empty();
    }

    /** The pattern of P^T A P for a matrix A of this pattern, joined to it. */
    void
    extend(dealii::DynamicSparsityPattern &pattern) const;

    /** result = P^T A P, on a pattern made by extend(). */
    void
    congruence(const DofMatrix &matrix, DofMatrix &result) const;

    /** Moves the mass: clears the rows and columns of the massless unknowns. */
    void
    move_mass(DofMatrix &mass) const;

    /** v <- P v: the massless nodes follow their neighbours. */
    void
    extrapolate(DofVector &vector) const;

    /** Puts zero at the massless unknowns. */
    void
    clear_massless(DofVector &vector) const;

    /** f <- P^T f at the unknown of a massless node: the force goes to the
     * nodes that carry its mass. */
    void
    hand_over(const unsigned int massless, DofVector &force) const;

  private:
    std::map<unsigned int, Row> rows_;      // P
    std::map<unsigned int, Row> receivers_; // of mass, with their shares
  };
} // namespace Signorini

#endif
