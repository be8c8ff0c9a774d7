#ifndef signorini_dynamics_rigid_mechanism_h
#define signorini_dynamics_rigid_mechanism_h

#include <signorini/contact/contact_model.h>
#include <signorini/linear_algebra/types.h>

#include <optional>
#include <vector>

namespace Signorini
{
  /**
   * The bodies as if they were stiff: the motions that supports leave free, the
   * loads along them, and what contacts can bear. With m_i the motions and w_k
   * the directions in which a contact can push (its normal, and with friction
   * the two edges of its cone) the bodies are in balance if there are
   * lambda >= 0 with
   *
   *   m_i . (F + sum_k lambda_k w_k) = 0   for all i.
   */
  template <int dim>
  class RigidMechanism
  {
  public:
    using Points = std::vector<ContactPoint<dim>>;

    /**
     * @param modes m_i over all unknowns, 1; the largest entry is about one
     * @param force F, N
     * The model must outlive the object.
     */
    RigidMechanism(const ContactModel<dim>      &contact,
                   const std::vector<DofVector> &modes,
                   const DofVector              &force);

    /** The first motion that no contact forces could balance, were all contacts
     * closed. */
    std::optional<unsigned int>
    find_unbalanced(const Points &points) const;

    /** Where the loads take the bodies. */
    struct Approach
    {
      // Contacts that are closed in the end balance the loads.
      bool            is_balanced = false;
      DofVector       way;    // of all unknowns, m
      InterfaceForces forces; // of these contacts, N

      // The motion that was not in balance at the beginning, if the bodies
      // went far without being stopped.
      std::optional<unsigned int> endless;
    };

    /**
     * Moves the bodies as the loads push them, without friction, until the
     * contacts that are closed can balance the loads. Motions are linear in the
     * modes.
     */
    Approach
    approach(const Configuration &start) const;

  private:
    // Contacts within a distance, and how they push.
    struct Columns
    {
      std::vector<std::vector<double>> powers; // m_i . w, one list a column
      std::vector<unsigned int>        contact;
      std::vector<double>              friction; // tangential part of w
      std::vector<double>              gaps;     // m, not negative
    };

    Columns
    columns(const Points &points,
            const double  largest_gap,
            const bool    with_friction) const;

    DofVector
    motion(const std::vector<double> &shares) const;

    const ContactModel<dim>      &contact_;
    const std::vector<DofVector> &modes_;
    std::vector<double>           load_; // m_i . F
  };
} // namespace Signorini

#endif
