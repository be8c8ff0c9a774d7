#ifndef signorini_contact_plane_h
#define signorini_contact_plane_h

#include <signorini/contact/rigid_surface.h>

namespace Signorini
{
  /** A straight line (2-D) or a plane (3-D): g = (x - p).n. */
  template <int dim>
  class Plane : public RigidSurface<dim>
  {
  public:
    /** @param normal any length but zero; points away from the target */
    Plane(const dealii::Point<dim>     &point,
          const dealii::Tensor<1, dim> &normal);

    static void
    declare_parameters(dealii::ParameterHandler &prm);

    static std::unique_ptr<RigidSurface<dim>>
    create(dealii::ParameterHandler &prm, const std::string &section);

    SurfacePoint<dim>
    closest(const dealii::Point<dim> &point) const override;

    bool
    is_flat() const override;

  private:
    dealii::Point<dim>     point_;
    dealii::Tensor<1, dim> normal_;
  };
} // namespace Signorini

#endif
