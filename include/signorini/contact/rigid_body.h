#ifndef signorini_contact_rigid_body_h
#define signorini_contact_rigid_body_h

#include <signorini/contact/contact_target.h>
#include <signorini/contact/rigid_placement.h>
#include <signorini/contact/rigid_surface.h>
#include <signorini/input/entry_condition.h>
#include <signorini/input/space_time_function.h>
#include <signorini/solid/rigid_body_dof.h>

#include <memory>
#include <string>
#include <vector>

namespace Signorini
{
  /**
   * A rigid body: a shape, and a motion that is given or, component by
   * component, found from its mass and the forces on it. A body with a free
   * component has unknowns: the displacement of its centre and, in 2-D, its
   * rotation, counted as an arc: q = lever times angle, so that all are
   * lengths and all forces on them are forces.
   */
  template <int dim>
  class RigidBody
  {
  public:
    /** Declares the entries of a section `Rigid body NAME`, from inside it. */
    static void
    declare_parameters(dealii::ParameterHandler &prm);

    /** Which entries are read under which choice. */
    static EntryConditions
    conditions();

    /**
     * Reads the section, from inside it.
     * @param directory     where the paths of files start
     * @param first_unknown the number of its first unknown, if it has any
     * @throws InputError.
     */
    RigidBody(const std::string        &name,
              const std::string        &directory,
              const Constants          &constants,
              const unsigned int        first_unknown,
              dealii::ParameterHandler &prm);

    const std::string &
    name() const
    {
      return name_;
    }

    const RigidSurface<dim> &
    surface() const
    {
      return *surface_;
    }

    /** True if normals never change: neither place nor time turns them. */
    bool
    is_flat() const;

    /** True if it has unknowns. */
    bool
    is_free() const
    {
      return is_free_;
    }

    /** Its unknowns, as the solid model wants them: none unless it is free. */
    std::vector<RigidBodyDof>
    unknowns() const;

    unsigned int
    first_unknown() const
    {
      return first_unknown_;
    }

    /** Number of displacements and rotations: 3 in 2-D, 3 in 3-D. */
    static constexpr unsigned int n_components = 3;

    /** Arc per angle of the unknown of rotation, m. */
    double
    lever() const
    {
      return lever_;
    }

    RigidPlacement<dim>
    placement(const Configuration &configuration) const;

  private:
    void
    parse_free_components(const std::string &list, const std::string &entry);

    void
    parse_inertia(const dealii::ParameterHandler &prm);

    void
    parse_initial_velocity(const Constants                &constants,
                           const dealii::ParameterHandler &prm);

    std::unique_ptr<SpaceTimeFunction<dim>>
    parse_function(const std::string              &entry,
                   const unsigned int              n_values,
                   const Dependence                dependence,
                   const Constants                &constants,
                   const dealii::ParameterHandler &prm) const;

    std::string                             name_;
    std::unique_ptr<RigidSurface<dim>>      surface_;
    dealii::Point<dim>                      centre_;
    std::unique_ptr<SpaceTimeFunction<dim>> motion_;   // none: at rest
    std::unique_ptr<SpaceTimeFunction<dim>> rotation_; // none: at rest
    std::unique_ptr<SpaceTimeFunction<dim>> force_;
    std::unique_ptr<SpaceTimeFunction<dim>> moment_;
    bool                                    is_free_           = false;
    std::array<bool, n_components>          is_component_free_ = {};
    std::array<double, n_components>        mass_              = {};
    std::array<double, n_components>        initial_velocity_  = {};
    double                                  lever_             = 1.;
    unsigned int                            first_unknown_;
  };
} // namespace Signorini

#endif
