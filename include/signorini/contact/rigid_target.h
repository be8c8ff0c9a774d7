#ifndef signorini_contact_rigid_target_h
#define signorini_contact_rigid_target_h

#include <signorini/contact/contact_target.h>
#include <signorini/contact/rigid_body.h>

namespace Signorini
{
  /**
   * A rigid body as a target. With the shape's own gap G in the frame of the
   * body, g(x, u, theta) = G(R^T (x - c - u) + c), so that with the relative
   * motion w = dx - du - dtheta J (x - c - u), J a quarter turn,
   *
   *   dg  = n.w,
   *   d2g = w.H w - 2 n.J (dx - du) dtheta - n.(x - c - u) dtheta^2,
   *
   * H = grad grad G turned into space.
   */
  template <int dim>
  class RigidTarget : public ContactTarget<dim>
  {
  public:
    /** The body must outlive the object. */
    explicit RigidTarget(const RigidBody<dim> &body);

    std::string
    name() const override;

    bool
    is_flat() const override;

    std::vector<unsigned int>
    unknowns() const override;

    std::unique_ptr<PlacedTarget<dim>>
    place(const Configuration &now, const Configuration &before) const override;

  private:
    const RigidBody<dim> &body_;
  };
} // namespace Signorini

#endif
