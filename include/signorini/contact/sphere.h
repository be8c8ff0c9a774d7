#ifndef signorini_contact_sphere_h
#define signorini_contact_sphere_h

#include <signorini/contact/rigid_surface.h>

namespace Signorini
{
  /**
   * Points at the same distance from a straight axis or a centre: circle (2-D),
   * sphere and circular cylinder (3-D). With d the vector from the axis to the
   * point, g = |d| - R outside and R - |d| inside.
   */
  template <int dim>
  class Sphere : public RigidSurface<dim>
  {
  public:
    /**
     * @param axis   direction of the cylinder, or zero for circle and sphere
     * @param inside true: a hole of this radius, contact comes from within
     */
    Sphere(const dealii::Point<dim>     &centre,
           const double                  radius,
           const dealii::Tensor<1, dim> &axis,
           const bool                    inside);

    /** @param name Circle, Sphere or Cylinder: the subsection's name. */
    static void
    declare_parameters(dealii::ParameterHandler &prm, const std::string &name);

    static std::unique_ptr<RigidSurface<dim>>
    create(dealii::ParameterHandler &prm,
           const std::string        &name,
           const std::string        &section);

    SurfacePoint<dim>
    closest(const dealii::Point<dim> &point) const override;

    bool
    is_flat() const override;

    std::vector<dealii::Point<dim>>
    outline() const override;

    double
    reference_length() const override
    {
      return radius_;
    }

  private:
    dealii::Point<dim>     centre_;
    double                 radius_;
    dealii::Tensor<1, dim> axis_;
    double                 sign_; // -1 inside
  };
} // namespace Signorini

#endif
