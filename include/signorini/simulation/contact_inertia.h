#ifndef signorini_simulation_contact_inertia_h
#define signorini_simulation_contact_inertia_h

#include <signorini/contact/contact_point.h>
#include <signorini/simulation/state.h>
#include <signorini/solid/solid_model.h>

#include <memory>
#include <vector>

namespace Signorini
{
  /**
   * The inertia of bodies whose nodes lose their mass when they come into
   * contact: those that nothing approaches keep it. A node that has lost its
   * mass stays without.
   */
  template <int dim>
  class ContactInertia
  {
  public:
    using Mass = typename SolidModel<dim>::RedistributedMass;

    /**
     * @param redistributes false: every node keeps its mass
     * @param smallest_gap  what counts as closed, m
     */
    ContactInertia(const SolidModel<dim> &solid,
                   const bool             redistributes,
                   const double           smallest_gap);

    /** The mass matrix that belongs to the massless nodes of a state, until
     * another is asked for. The solid must have mass. */
    const Mass &
    mass(const State &state);

    /**
     * Nodes with mass, by their first unknown, of open contacts that will close
     * within two steps at the present velocity.
     * @param points placed at the displacement of @p state
     */
    std::vector<unsigned int>
    approaching(const std::vector<ContactPoint<dim>> &points,
                const State                          &state,
                const double                          step_size) const;

    /** Nodes with mass on which contact forces act. */
    std::vector<unsigned int>
    pressed(const std::vector<ContactPoint<dim>> &points,
            const InterfaceForces                &forces,
            const State                          &state) const;

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

  private:
    void
    add_massive(const SparseRow           &row,
                const State               &state,
                std::vector<unsigned int> &nodes) const;

    const SolidModel<dim>      &solid_;
    bool                        redistributes_;
    double                      smallest_gap_;
    std::vector<unsigned int>   node_of_unknown_; // by its first unknown
    std::vector<unsigned int>   massless_nodes_;  // of mass_
    std::unique_ptr<const Mass> mass_;
  };
} // namespace Signorini

#endif
