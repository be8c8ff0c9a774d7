#ifndef signorini_contact_rigid_body_h
#define signorini_contact_rigid_body_h

#include <signorini/contact/rigid_surface.h>
#include <signorini/space_time_function.h>

#include <memory>
#include <string>

namespace Signorini
{
  /** A rigid target: a shape and a prescribed translation. */
  template <int dim>
  class RigidBody
  {
  public:
    /** Declares the entries of a section `Rigid body NAME`, from inside it. */
    static void
    declare_parameters(dealii::ParameterHandler &prm);

    /** Reads the section, from inside it. @throws InputError. */
    RigidBody(const std::string        &name,
              const Constants          &constants,
              dealii::ParameterHandler &prm);

    const std::string &
    name() const
    {
      return name_;
    }

    bool
    is_flat() const
    {
      return surface_->is_flat();
    }

    /** Displacement since t = 0, m. */
    dealii::Tensor<1, dim>
    translation(const double time) const;

    /** The surface displaced by a translation, seen from a point. */
    SurfacePoint<dim>
    closest(const dealii::Point<dim>     &point,
            const dealii::Tensor<1, dim> &translation) const
    {
      return surface_->closest(point - translation);
    }

  private:
    std::string                             name_;
    std::unique_ptr<RigidSurface<dim>>      surface_;
    std::unique_ptr<SpaceTimeFunction<dim>> motion_; // none: at rest
  };
} // namespace Signorini

#endif
