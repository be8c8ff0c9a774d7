#ifndef signorini_contact_contact_model_h
#define signorini_contact_contact_model_h

#include <signorini/contact/contactor_surface.h>
#include <signorini/contact/rigid_body.h>
#include <signorini/variational_inequality/interface_problem.h>

#include <deal.II/lac/vector.h>

#include <memory>
#include <string>
#include <vector>

namespace Signorini
{
  /** A boundary of a body and the rigid target it may touch. */
  template <int dim>
  struct ContactPair
  {
    std::string            name; // column prefix in the history
    const Body<dim>       *body;
    const RigidBody<dim>  *target;
    ContactorSurface<dim>  contactor;
    std::vector<Node<dim>> held_nodes;    // that cannot follow a contact force
    unsigned int           first_contact; // in the count of all pairs
  };

  /**
   * All contact pairs: which unknowns they touch, and for each candidate node
   * the gap, its gradient and its curvature at a displacement. Candidates are
   * counted through, pair by pair.
   */
  template <int dim>
  class ContactModel
  {
  public:
    /** A boundary of a body against a target, as named in the .prm. */
    struct PairNames
    {
      const Body<dim>      *body;
      std::string           boundary;
      const RigidBody<dim> *target;
    };

    /**
     * @param is_fixed   unknowns that do not move with the solution; nodes that
     *                   cannot move at all are no candidates
     * @param is_hanging those of them that follow their neighbours
     */
    ContactModel(const std::vector<PairNames> &pairs,
                 const std::vector<bool>      &is_fixed,
                 const std::vector<bool>      &is_hanging);

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

    /** The free unknowns of all candidate nodes. */
    const std::vector<unsigned int> &
    interface_dofs() const
    {
      return interface_dofs_;
    }

    /** True if all targets are flat: then rows never change. */
    bool
    is_flat() const;

    /** Gap, normal and curvature of each candidate (m, 1, 1/m). */
    std::vector<SurfacePoint<dim>>
    evaluate(const dealii::Vector<double> &displacement,
             const double                  time) const;

    /**
     * What is wrong in words if a node that is held, and therefore no
     * candidate, lies inside of a target; empty otherwise.
     */
    std::string
    held_penetration(const dealii::Vector<double> &displacement,
                     const double                  time) const;

    /** `floor at (0 0), ...' for the first few of these candidates. */
    std::string
    candidates_in_words(const std::vector<unsigned int> &candidates) const;

    /** Rows A_k = -n on the interface unknowns, and gaps G_k. */
    std::vector<InterfaceContact>
    constraints(const std::vector<SurfacePoint<dim>> &points) const;

    /** forces += factor sum_k n_k lambda_k on the candidate nodes. */
    void
    add_contact_forces(const std::vector<SurfacePoint<dim>> &points,
                       const std::vector<double>            &normal_forces,
                       const double                          factor,
                       dealii::Vector<double>               &forces) const;

    /**
     * The geometric contact term - sum_k lambda_k grad grad g_k on the
     * interface unknowns, added to a dense matrix. N/m.
     */
    void
    add_geometric_stiffness(const std::vector<SurfacePoint<dim>> &points,
                            const std::vector<double>            &normal_forces,
                            dealii::FullMatrix<double> &stiffness) const;

  private:
    // Calls f(k, node, pair) for every candidate.
    template <typename Function>
    void
    for_each_candidate(const Function &f) const;

    std::vector<ContactPair<dim>> pairs_;
    unsigned int                  n_contacts_ = 0;
    std::vector<unsigned int>     interface_dofs_;
    std::vector<unsigned int>     interface_index_; // of all unknowns
  };
} // namespace Signorini

#endif
