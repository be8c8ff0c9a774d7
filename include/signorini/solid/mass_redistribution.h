#ifndef signorini_solid_mass_redistribution_h
#define signorini_solid_mass_redistribution_h

#include <signorini/solid/body.h>

#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/sparse_matrix.h>
#include <deal.II/lac/vector.h>

#include <map>
#include <utility>
#include <vector>

namespace Signorini
{
  /** Where the mass of nodes that may come into contact goes. */
  enum class ContactMass
  {
    consistent,    // it stays
    redistributed, // to the nearest inner nodes
    affine         // to inner nodes in two layers, such that affine velocity
                   // fields keep their kinetic energy
  };

  /**
   * Takes the inertia off the nodes that may come into contact. Their velocity
   * is a mean or an extrapolation of inner nodes, v_c = sum_j w_cj v_j, so that
   * with P the matrix that puts it in place the mass matrix becomes
   *
   *   M_r = P^T M P,
   *
   * which is symmetric, has no entries at the contact nodes and is positive
   * definite on the others. Constants are reproduced always: total mass and
   * linear momentum are those of M. The affine weights reproduce linear
   * functions too, hence centre of mass and moments of inertia are kept
   * (cf. Khenous, Laborde & Renard 2008; Hager & Wohlmuth 2008); but they put
   * three times the mass of a row of nodes on the second one, against which
   * waves rattle: the contact force of a bar that meets a wall rings for 62
   * steps instead of 8.
   */
  class MassRedistribution
  {
  public:
    /** (unknown, weight) */
    using Row = std::vector<std::pair<unsigned int, double>>;

    /**
     * Finds the weights of the contact nodes of a body.
     *
     * @param kind          redistributed or affine
     * @param contact_nodes nodes that lose their mass
     * @param is_fixed      unknowns of given motion, which keep their mass
     * @param is_hanging    unknowns of hanging nodes, which take no mass
     * @throws InputError when a body has too few inner nodes.
     */
    template <int dim>
    void
    add(const ContactMass             kind,
        const Body<dim>              &body,
        const std::vector<Node<dim>> &contact_nodes,
        const std::vector<bool>      &is_fixed,
        const std::vector<bool>      &is_hanging);

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
    congruence(const dealii::SparseMatrix<double> &matrix,
               dealii::SparseMatrix<double>       &result) const;

    /** v <- P v: the massless nodes follow their neighbours. */
    void
    extrapolate(dealii::Vector<double> &vector) const;

    /** Puts zero at the massless unknowns. */
    void
    clear_massless(dealii::Vector<double> &vector) const;

  private:
    std::map<unsigned int, Row> rows_;
  };
} // namespace Signorini

#endif
