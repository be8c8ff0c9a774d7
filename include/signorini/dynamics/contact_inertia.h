#ifndef signorini_dynamics_contact_inertia_h
#define signorini_dynamics_contact_inertia_h

#include <signorini/contact/contact_model.h>
#include <signorini/dynamics/state.h>
#include <signorini/linear_algebra/types.h>
#include <signorini/solid/solid_model.h>

#include <functional>
#include <memory>
#include <vector>

namespace Signorini
{
  /**
   * The inertia of bodies whose surfaces lose their mass when they come into
   * contact: all candidates of a pair with the first of them that closes, or
   * from the start if the pair is near. They stay without, unless all get
   * their mass back. Pairs that are far and never touch change nothing.
   */
  template <int dim>
  class ContactInertia
  {
  public:
    using Mass = typename SolidModel<dim>::RedistributedMass;

    /** @param redistributes false: every node keeps its mass */
    ContactInertia(const SolidModel<dim>   &solid,
                   const ContactModel<dim> &contact,
                   const bool               redistributes);

    /** The mass matrix that belongs to the massless nodes of a state, until
     * another is asked for. The solid must have mass. */
    const Mass &
    mass(const State &state);

    /** Nodes with mass, by their first unknown, of pairs with a gap within a
     * distance. */
    std::vector<unsigned int>
    near(const std::vector<ContactPoint<dim>> &points,
         const State                          &state,
         const double                          distance) const;

    /**
     * Nodes with mass, by their first unknown, of pairs of which an open
     * contact will close within two steps at the present velocity.
     * @param points placed at the displacement of @p state
     */
    std::vector<unsigned int>
    approaching(const std::vector<ContactPoint<dim>> &points,
                const State                          &state,
                const double                          step_size) const;

    /** Nodes with mass of pairs on which contact forces act. */
    std::vector<unsigned int>
    pressed(const InterfaceForces &forces, const State &state) const;

    /**
     * The state after nodes have lost their mass. Displacements and energies
     * stay; velocities v change with the mass matrix, M to M', such that
     * momentum and angular momentum stay, too:
     *
     *   v' = R a + s (v - R b),  R^T M' R (a, b) = R^T (M, M') v,
     *
     * R the rigid motions of a body that its supports leave free, and s, near
     * 1, keeps the kinetic energy. What forces the nodes would accelerate goes
     * with their mass.
     */
    State
    take_mass(const State &state, const std::vector<unsigned int> &nodes);

    /**
     * The state after all nodes got their mass back, for the rest of the run.
     * Momenta and energy are kept in the same way.
     */
    State
    give_mass(const State &state);

  private:
    // Velocities of bodies whose nodes lost or got mass.
    void
    keep_motion(const DofMatrix                 &old_mass,
                const DofMatrix                 &mass,
                const std::vector<unsigned int> &nodes,
                const DofVector                 &old_velocity,
                State                           &result) const;

    // Nodes with mass of pairs with a candidate that is close.
    std::vector<unsigned int>
    of_pairs(const State                                   &state,
             const std::function<bool(const unsigned int)> &is_close) const;

    void
    add_massive(const ContactPair<dim>    &pair,
                const State               &state,
                std::vector<unsigned int> &nodes) const;

    const SolidModel<dim>      &solid_;
    const ContactModel<dim>    &contact_;
    bool                        redistributes_;
    std::vector<unsigned int>   node_of_unknown_; // by its first unknown
    std::vector<unsigned int>   massless_nodes_;  // of mass_
    std::unique_ptr<const Mass> mass_;
  };
} // namespace Signorini

#endif
