#ifndef signorini_contact_deforming_target_h
#define signorini_contact_deforming_target_h

#include <signorini/contact/contact_target.h>
#include <signorini/contact/contactor_surface.h>
#include <signorini/contact/surface_interpolation.h>

#include <string>
#include <vector>

namespace Signorini
{
  /** The boundary of a deformable body as a target, however interpolated. */
  template <int dim>
  class DeformingTarget : public ContactTarget<dim>
  {
  public:
    std::string
    name() const override;

    bool
    is_flat() const override;

    std::vector<unsigned int>
    unknowns() const override;

  protected:
    /** The body must outlive the object. @throws InputError. */
    DeformingTarget(const Body<dim>            &body,
                    const std::string          &boundary,
                    const SurfaceInterpolation &interpolation);

    const std::string           name_;
    const ContactorSurface<dim> surface_;
    double                      reach_;             // m
    double                      penetration_limit_; // m
  };
} // namespace Signorini

#endif
