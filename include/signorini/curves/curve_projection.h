#ifndef signorini_curves_curve_projection_h
#define signorini_curves_curve_projection_h

#include <signorini/curves/curve.h>

#include <vector>

namespace Signorini
{
  /** A point x seen from the nearest point y of a curve. */
  struct CurveProjection
  {
    unsigned int         segment;
    double               xi;
    dealii::Point<2>     point;   // y, m
    dealii::Tensor<1, 2> normal;  // n, outward unit vector
    dealii::Tensor<1, 2> tangent; // unit vector, along growing parameter
    double               gap;     // g = (x - y).n, m; negative inside
    bool                 is_vertex;
    double               speed;     // |y'|, m
    double               curvature; // n.y'', m: over |y'|^2 in 1/m

    CurveParameter
    place() const
    {
      return {segment, xi};
    }
  };

  /** x above a place of the curve, whether it is the nearest one or not. */
  CurveProjection
  projection_at(const Curve            &curve,
                const CurveParameter   &place,
                const dealii::Point<2> &x);

  /**
   * Appends the places of a segment, with the joint at its end, where the
   * distance from x is least compared with their neighbourhood on the curve.
   * The ends of an open curve belong to the first and the last segment.
   *
   * Inside of a segment (x - y).y' = 0, a polynomial of degree 5 all of whose
   * roots are found. A joint counts if the distance falls towards it on both
   * sides. Then, if it turns by more than 1e-6 rad, whether it is called a
   * corner or not, x lies in its normal cone: the projection is a vertex, and g
   * = +-|x - y|, n = (x - y)/g, positive for x outside of a convex corner,
   * negative for x inside of a reentrant one. With x at the vertex itself n is
   * the middle of the cone.
   *
   * At the end of an open curve there is a least distance for x beyond it
   *  - never if it is free, except by rounding (1e-6 of the chord);
   *  - always if it is symmetric: x can only be beyond by rounding, and the
   *    normal stays that of the end;
   *  - if it is a corner, within the cone between the normals of the curve and
   *    of the boundary that follows.
   */
  void
  find_nearest_places(const Curve                  &curve,
                      const unsigned int            segment,
                      const dealii::Point<2>       &x,
                      std::vector<CurveProjection> &places);
} // namespace Signorini

#endif
