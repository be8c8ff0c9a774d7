#ifndef signorini_contact_facet_target_h
#define signorini_contact_facet_target_h

#include <signorini/contact/deforming_target.h>

#include <string>
#include <vector>

namespace Signorini
{
  /**
   * The boundary of a deformable body in 3-D as a target: bilinear facets
   * y = sum_a N_a y_a through its nodes, with a normal field that does not
   * jump, n = m/|m|, m = sum_a N_a n_a, from the normals n_a at the nodes. The
   * point y opposite to x is that where
   *
   *   x = y(xi, eta) + g n(xi, eta),
   *
   * so that the gap g has no jump where facets meet, either
   * [PusoLaursen2004]. Its gradient is taken as n.(dx - sum_a N_a dy_a), which
   * leaves out n.y_xi dxi: nothing on a flat surface, of the order of the angle
   * between facets times the slip on a curved one.
   */
  class FacetTarget : public DeformingTarget<3>
  {
  public:
    /** The body must outlive the object. @throws InputError. */
    FacetTarget(const Body<3>              &body,
                const std::string          &boundary,
                const SurfaceInterpolation &interpolation);

    std::unique_ptr<PlacedTarget<3>>
    place(const Configuration &now, const Configuration &before) const override;

  private:
    const std::vector<std::vector<unsigned int>> facets_of_nodes_;
  };
} // namespace Signorini

#endif
