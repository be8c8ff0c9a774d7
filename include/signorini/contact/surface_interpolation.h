#ifndef signorini_contact_surface_interpolation_h
#define signorini_contact_surface_interpolation_h

#include <signorini/curves/curve_weights.h>

namespace Signorini
{
  /** How the surface of a deforming target is interpolated and searched. */
  struct SurfaceInterpolation
  {
    enum class Kind
    {
      spline, // Overhauser's curve
      facets, // straight between nodes
      trace   // as the elements have it
    };

    Kind                kind          = Kind::spline;
    CurveWeights::Knots knots         = CurveWeights::Knots::centripetal;
    double              feature_angle = 40.; // degrees

    // How far a contactor point looks for the target, and how deep inside it
    // is still taken for a penetration; in lengths of the longest piece.
    double reach = 10.;
    double depth = 3.;
  };
} // namespace Signorini

#endif
