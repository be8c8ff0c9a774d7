#ifndef signorini_solid_solid_model_h
#define signorini_solid_solid_model_h

#include <signorini/linear_algebra/types.h>
#include <signorini/solid/assembler.h>
#include <signorini/solid/body.h>
#include <signorini/solid/dof_map.h>
#include <signorini/solid/loads.h>
#include <signorini/solid/mass_redistribution.h>
#include <signorini/solid/rigid_body_dof.h>
#include <signorini/solid/rigid_motion.h>
#include <signorini/solid/supports.h>
#include <signorini/time/time_parameters.h>

#include <deal.II/lac/sparsity_pattern.h>

#include <functional>
#include <memory>
#include <vector>

namespace Signorini
{
  /**
   * All deformable bodies together: their unknowns in one count, their forces
   * and matrices. Knows nothing of contact but which nodes lose their mass.
   */
  template <int dim>
  class SolidModel
  {
  public:
    /** One more body, with its loads and supports. */
    struct Part
    {
      std::unique_ptr<Body<dim>> body;
      Loads<dim>                 loads;
      Supports<dim>              supports;
    };

    /** How inertia is discretised. */
    struct Inertia
    {
      bool        present      = true; // false: static
      bool        lumped       = false;
      ContactMass contact_mass = ContactMass::consistent;

      // One list a body, of the nodes that may come into contact: each must
      // have inner nodes around it, and none is damped itself.
      std::vector<std::vector<Node<dim>>> contact_nodes;
    };

    /** The mass matrix when some nodes have lost their mass. */
    struct RedistributedMass
    {
      DofMatrix                matrix;
      MassRedistribution       redistribution;
      std::vector<std::string> changed_bodies; // in a moment of mass
    };

    /** @param rigid_body_dofs counted after those of the bodies */
    explicit SolidModel(std::vector<Part>         parts,
                        std::vector<RigidBodyDof> rigid_body_dofs = {});

    /**
     * Builds the sparsity pattern and assembles stiffness, mass and damping.
     * @throws InputError when a body of a dynamic run has no mass, or one of a
     * static run absorbing boundaries.
     */
    void
    assemble(const Inertia &inertia);

    const std::vector<Part> &
    parts() const
    {
      return parts_;
    }

    /** The body of this name. @throws InputError with the list of names. */
    const Body<dim> &
    body(const std::string &name, const std::string &entry) const;

    unsigned int
    n_dofs() const
    {
      return dof_map_.size();
    }

    const DofMap &
    dof_map() const
    {
      return dof_map_;
    }

    /** True if no unknown has a motion that depends on time. */
    bool
    supports_are_fixed() const
    {
      return supports_are_fixed_;
    }

    const dealii::SparsityPattern &
    sparsity() const
    {
      return sparsity_;
    }

    /** True if K is the same at all displacements and nothing is remembered:
     * F_int = K U. */
    bool
    is_linear() const
    {
      return is_linear_;
    }

    /** At the start, without displacement. */
    const DofMatrix &
    stiffness() const
    {
      return stiffness_;
    }

    /** M, with the mass of all nodes. */
    const DofMatrix &
    mass() const
    {
      return mass_;
    }

    /** The same without the mass of some nodes, given by their first unknown:
     * mass, centre and moments of inertia of each body are kept. */
    std::unique_ptr<const RedistributedMass>
    redistribute_mass(const std::vector<unsigned int> &massless_nodes) const;

    /** a M + b K and the dashpots of absorbing boundaries; empty when no body
     * is damped. */
    const DofMatrix &
    damping() const
    {
      return damping_;
    }

    bool
    is_damped() const
    {
      return !damping_.empty();
    }

    /**
     * A basis of what supports leave free of the motions as a whole: of each
     * connected part of the bodies, and of each free unknown of a rigid body.
     * Nothing but contact holds these in a static run.
     * @param displacement where the bodies are, m
     */
    std::vector<RigidMode>
    free_modes(const DofVector &displacement) const;

    /** "the node (POINT) of body NAME", or "a rigid body". */
    std::string
    unknown_in_words(const unsigned int unknown) const;

    /** What all points remember before anything has happened. */
    std::vector<double>
    initial_history() const;

    /**
     * Internal forces, energies and new history of the points.
     *
     * @param step    from the state of @p history_n to this displacement; with
     *                its start the mean force is found, too, see add_response()
     * @param tangent   gets the tangent stiffness unless null; not for linear
     *                  solids, whose stiffness() it is
     * @throws MaterialFailure
     */
    SolidResponse
    respond(const SolidStep           &step,
            const std::vector<double> &history_n,
            DofMatrix                 *tangent = nullptr) const;

    /**
     * To what internal forces are known, N: machine precision times
     * sum_j |K_ij| (|U_j| + h_j). The first are the terms of K U; with h, the
     * size of the cells around, they are those of the deformation gradient
     * 1 + grad U, where it is formed.
     */
    DofVector
    force_rounding(const DofVector &displacement) const;

    /** The part of the histories of all bodies that is that of body @p b. */
    dealii::ArrayView<const double>
    history_of(const unsigned int b, const std::vector<double> &history) const;

    /** F(t, U), N; at given unknowns the load on the support. The displacement
     * matters with finite strains only. */
    const DofVector &
    external_force(const double time, const DofVector &displacement) const;

    /** True if external_force() depends on the displacement. */
    bool
    loads_follow() const
    {
      return loads_follow_;
    }

    /** Given motions at this time, and hanging nodes after their masters. */
    void
    apply_supports(const double time, DofVector &displacement) const;

    void
    apply_support_rates(const double time,
                        const double step_size,
                        DofVector   &velocity,
                        DofVector   &acceleration) const;

    /**
     * Static work of the loads at t = end: the stiffness |R|^2/(F.u) of the
     * bodies where they are loaded, with K u = F and R the resultant of F.
     * Unit: N/m. @throws InputError when there is no load or no stiffness.
     */
    double
    stiffness_at_load(const double time) const;

  private:
    void
    number_dofs(const unsigned int n_body_dofs);
    void
    build_sparsity();
    bool
    has_damping() const;
    void
    assemble_inertia(const Inertia &inertia);
    void
    measure_cells();
    void
    refuse_absorbing_boundaries() const;

    // Adds the stiffness of each body without displacement times its factor.
    void
    add_initial_stiffness(
      const std::function<double(const Body<dim> &)> &factor,
      DofMatrix                                      &matrix) const;

    std::vector<Part>         parts_;
    std::vector<RigidBodyDof> rigid_body_dofs_;
    DofMap                    dof_map_;
    MassRedistribution        undamped_; // all that may touch
    dealii::SparsityPattern   sparsity_;
    DofMatrix                 stiffness_;
    DofVector                 cell_size_; // around each unknown, m
    DofMatrix                 mass_;
    DofMatrix                 damping_;
    bool                      is_linear_;
    std::vector<unsigned int> first_history_; // of each body, and end
    bool                      loads_vary_;
    bool                      loads_follow_;
    bool                      supports_are_fixed_;

    // The forces last asked for, and their time.
    mutable double    force_time_;
    mutable DofVector force_;           // without what follows
    mutable DofVector following_force_; // all, if some follow
  };
} // namespace Signorini

#endif
