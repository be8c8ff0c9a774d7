#ifndef signorini_contact_contact_model_h
#define signorini_contact_contact_model_h

#include <signorini/contact/contact_pair.h>
#include <signorini/contact/contact_point.h>
#include <signorini/contact/contact_state.h>
#include <signorini/contact/gap_offset.h>
#include <signorini/contact/interface_numbering.h>
#include <signorini/linear_algebra/types.h>
#include <signorini/solid/dof_map.h>
#include <signorini/variational_inequality/interface_problem.h>
#include <signorini/variational_inequality/interface_types.h>

#include <string>
#include <vector>

namespace Signorini
{
  /**
   * All contact pairs: which unknowns they touch, and for each candidate node
   * gap, slip, their gradients and the curvature of the gap at a displacement.
   * Candidates are counted through, pair by pair.
   */
  template <int dim>
  class ContactModel
  {
  public:
    using PairDescription = ContactPairDescription<dim>;

    /**
     * @param dof_map must outlive the object. Nodes that cannot move at all
     *                are no candidates, and hanging ones follow others.
     */
    ContactModel(std::vector<PairDescription> pairs, const DofMap &dof_map);

    const std::vector<ContactPair<dim>> &
    pairs() const
    {
      return pairs_;
    }

    unsigned int
    n_contacts() const
    {
      return n_contacts_;
    }

    /** The free unknowns of all candidate nodes and targets. */
    const std::vector<unsigned int> &
    interface_dofs() const
    {
      return interface_.unknowns();
    }

    /** The largest coordinate of a candidate node, m: the scale of rounding. */
    double
    extent() const
    {
      return extent_;
    }

    /** To what gaps are known, m: over a curved target they are sums of about
     * ten products of coordinates, each rounded. */
    double
    rounding() const
    {
      return 4e-15 * extent_;
    }

    /** True if all targets are flat: then rows never change. */
    bool
    is_flat() const;

    /** True if all pairs slide without friction. */
    bool
    is_frictionless() const;

    /** What is added to the gaps of a pair from now on. */
    void
    set_offset(const ContactPair<dim> &pair, GapOffset offset);

    /** Before anything has happened: no force, no slip, nothing worn. */
    ContactState
    initial_state() const;

    /** Marks the closed contacts that a velocity (m/s) makes slip. */
    void
    begin_slip(const std::vector<ContactPoint<dim>> &points,
               const DofVector                      &velocity,
               ContactState                         &state) const;

    /**
     * Brings gaps, slip and what the contact processes keep to the end of a
     * step. Forces and is_slipping are those of its end already.
     * @param step_size s
     */
    void
    advance(const double                          step_size,
            const std::vector<ContactPoint<dim>> &points,
            ContactState                         &state) const;

    /**
     * What each candidate sees of its target.
     * @param before the start of the step, from where slip is measured, and
     *               whose state of the contacts says how much is worn
     */
    std::vector<ContactPoint<dim>>
    evaluate(const Configuration &now, const Configuration &before) const;

    /** The same without a step: no slip. */
    std::vector<ContactPoint<dim>>
    evaluate(const Configuration &now) const
    {
      return evaluate(now, now);
    }

    /**
     * What is wrong in words if a node that is held, and therefore no
     * candidate, lies inside of a target; empty otherwise.
     */
    std::string
    held_penetration(const Configuration &configuration) const;

    /**
     * Open candidates that pass through their target within the step, although
     * they are outside at its end.
     * @param start_gaps at the start of the step, m
     * @param closed     candidates with a contact force at either end
     */
    std::vector<unsigned int>
    tunnelling_candidates(const Configuration       &now,
                          const Configuration       &before,
                          const std::vector<double> &start_gaps,
                          const std::vector<bool>   &closed) const;

    /**
     * How much further the surfaces will have receded in the next step, of each
     * candidate, m.
     * @param points of this step
     * @param state  at its end
     */
    std::vector<double>
    recession_gains(const std::vector<ContactPoint<dim>> &points,
                    const ContactState                   &state) const;

    /** `floor at (0 0), ...' for the first few of these candidates. */
    std::string
    candidates_in_words(const std::vector<unsigned int> &candidates) const;

    /** The pair of a candidate. */
    const ContactPair<dim> &
    pair_of(const unsigned int candidate) const;

    /**
     * The constraint Jacobian on the interface unknowns, A_k = -dg/dq and
     * T_k = ds/dq, with gaps, slips and friction bounds.
     * @param at_start of the step, from which mu follows
     */
    std::vector<InterfaceContact>
    constraints(const std::vector<ContactPoint<dim>> &points,
                const ContactState                   &at_start) const;

    /** forces += factor sum_k (lambda_k dg_k/dq - tau_k.ds_k/dq). */
    void
    add_contact_forces(const std::vector<ContactPoint<dim>> &points,
                       const InterfaceForces                &contact_forces,
                       const double                          factor,
                       DofVector                            &forces) const;

    /**
     * The geometric contact term - sum_k lambda_k grad grad g_k on the
     * interface unknowns, in small blocks that add up. N/m.
     */
    std::vector<StiffnessBlock>
    geometric_stiffness(const std::vector<ContactPoint<dim>> &points,
                        const std::vector<double> &normal_forces) const;

  private:
    unsigned int
    number_of(const ContactPair<dim> &pair) const;

    // @param state may be null: nothing is worn.
    void
    add_offsets(const ContactPair<dim>         &pair,
                const double                    time,
                const ContactState             *state,
                std::vector<ContactPoint<dim>> &points) const;

    void
    number_interface();

    // Calls f(k, node, pair) for every candidate.
    template <typename Function>
    void
    for_each_candidate(const Function &f) const;

    const DofMap                 &dof_map_;
    std::vector<ContactPair<dim>> pairs_;

    std::vector<GapOffset> offsets_; // one a pair

    unsigned int       n_contacts_ = 0;
    double             extent_     = 0.;
    InterfaceNumbering interface_;
  };
} // namespace Signorini

#endif
