#ifndef signorini_contact_deforming_curve_h
#define signorini_contact_deforming_curve_h

#include <signorini/contact/boundary_chain.h>
#include <signorini/contact/deforming_target.h>
#include <signorini/curves/curve_weights.h>

#include <string>
#include <vector>

namespace Signorini
{
  /**
   * The boundary of a plane deformable body as a target: Overhauser's curves
   * or facets through its nodes [MC, sec. 4]. The knots, and with them the
   * weights of the nodes, come from the reference position.
   */
  class DeformingCurve : public DeformingTarget<2>
  {
  public:
    /** The body must outlive the object. @throws InputError. */
    DeformingCurve(const Body<2>              &body,
                   const std::string          &boundary,
                   const DofMap               &dof_map,
                   const SurfaceInterpolation &interpolation);

    std::unique_ptr<PlacedTarget<2>>
    place(const Configuration &now, const Configuration &before) const override;

    /** A chain of nodes and the curve through it. */
    struct Chain
    {
      BoundaryChain nodes;
      CurveWeights  weights;
    };

  private:
    std::vector<Chain> chains_;
  };
} // namespace Signorini

#endif
