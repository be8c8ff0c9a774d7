#ifndef signorini_solid_loads_h
#define signorini_solid_loads_h

#include <signorini/input/entry_condition.h>
#include <signorini/input/space_time_function.h>
#include <signorini/linear_algebra/types.h>
#include <signorini/solid/body.h>

#include <string>
#include <vector>

namespace Signorini
{
  /**
   * The loads on a body: tractions, pressures, forces on the volume and at
   * points, each a function of the reference position and of time.
   */
  template <int dim>
  class Loads
  {
  public:
    /** Declares the section `Loads`. */
    static void
    declare_parameters(dealii::ParameterHandler &prm);

    /** Which entries are read under which choice. */
    static EntryConditions
    conditions();

    /** Reads the section `Loads` of this body. @throws InputError. */
    Loads(const Body<dim>          &body,
          const Constants          &constants,
          dealii::ParameterHandler &prm);

    /** False if the forces are the same at all times. */
    bool
    depend_on_time() const;

    /**
     * Adds the nodal forces (N) at this time to a vector over all unknowns.
     *   F_a = int N_a b dV + int N_a t dA + point forces
     * with b the body force, density times gravity and the centrifugal
     * density omega^2 (distance vector to the axis), t the traction and minus
     * the pressure times the outward normal.
     */
    void
    add_forces(const double time, DofVector &forces) const;

    /** True if some loads depend on the displacement: with finite strains
     * pressures stay normal to the surface and grow with it, and the
     * centrifugal load grows with the distance from the axis. */
    bool
    follow() const;

    /**
     * Adds the loads that follow the body, which add_forces() leaves out:
     *   F_a = - int N_a p J F^-T n dA + int N_a rho omega^2 (arm of x) dV.
     * @param displacement of all unknowns, m
     */
    void
    add_following_forces(const double     time,
                         const DofVector &displacement,
                         DofVector       &forces) const;

  private:
    using Function = SpaceTimeFunction<dim>;

    struct BoundaryLoad
    {
      dealii::types::boundary_id boundary;
      bool                       is_pressure;
      Function                   value;
    };

    struct PointForce
    {
      Node<dim> node;
      Function  value;
    };

    void
    parse_boundary_loads(const std::string        &entry_name,
                         const bool                is_pressure,
                         const Constants          &constants,
                         dealii::ParameterHandler &prm);

    void
    parse_point_forces(const Constants          &constants,
                       dealii::ParameterHandler &prm);

    void
    parse_rotation(const Constants &constants, dealii::ParameterHandler &prm);

    bool
    is_finite() const
    {
      return body_->kinematics() == Kinematics::finite_strain;
    }

    // Of the loads that keep their place.
    dealii::Tensor<1, dim>
    force_density(const dealii::Point<dim> &point,
                  const double              density,
                  const double              time) const;

    // Per mass; where the point is now and where it was. m/s^2
    dealii::Tensor<1, dim>
    centrifugal_acceleration(const dealii::Point<dim> &now,
                             const dealii::Point<dim> &at_first,
                             const double              time) const;

    // Both: the loads that keep their place, or, with a displacement, those
    // that follow the body.
    void
    add_volume_forces(const double     time,
                      const DofVector *displacement,
                      DofVector       &forces) const;

    void
    add_boundary_forces(const double     time,
                        const DofVector *displacement,
                        DofVector       &forces) const;

    const Body<dim>          *body_;
    std::vector<Function>     body_forces_;   // N/m^3
    std::vector<Function>     accelerations_; // m/s^2
    std::vector<Function>     rotation_;      // rad/s; none or one
    dealii::Point<dim>        rotation_centre_;
    dealii::Tensor<1, dim>    rotation_axis_; // zero in the plane
    std::vector<BoundaryLoad> boundary_loads_;
    std::vector<PointForce>   point_forces_;
  };
} // namespace Signorini

#endif
