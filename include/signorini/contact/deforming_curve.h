#ifndef signorini_contact_deforming_curve_h
#define signorini_contact_deforming_curve_h

#include <signorini/contact/boundary_chain.h>
#include <signorini/contact/contact_target.h>
#include <signorini/contact/curve_search.h>
#include <signorini/contact/curve_weights.h>
#include <signorini/contact/surface_interpolation.h>

#include <string>
#include <vector>

namespace Signorini
{
  /**
   * The boundary of a plane deformable body as a target: Overhauser's curves
   * or facets through its nodes [MC, sec. 4]. The knots, and with them the
   * weights of the nodes, come from the reference position.
   */
  class DeformingCurve : public ContactTarget<2>
  {
  public:
    /** The body must outlive the object. @throws InputError. */
    DeformingCurve(const Body<2>              &body,
                   const std::string          &boundary,
                   const std::vector<bool>    &is_fixed,
                   const SurfaceInterpolation &interpolation);

    std::string
    name() const override;

    bool
    is_flat() const override;

    std::vector<unsigned int>
    unknowns() const override;

    std::unique_ptr<PlacedTarget<2>>
    place(const Configuration &now, const Configuration &before) const override;

    /** A chain of nodes and the curve through it. */
    struct Chain
    {
      BoundaryChain nodes;
      CurveWeights  weights;
    };

  private:
    std::string        name_;
    std::vector<Chain> chains_;
    double             reach_;             // m
    double             penetration_limit_; // m
  };
} // namespace Signorini

#endif
