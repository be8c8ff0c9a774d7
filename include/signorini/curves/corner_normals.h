#ifndef signorini_curves_corner_normals_h
#define signorini_curves_corner_normals_h

#include <signorini/curves/curve_projection.h>
#include <signorini/curves/curve_search.h>

#include <optional>

namespace Signorini
{
  /**
   * The end of an open curve as the nearest place for a point beside it, by so
   * little (1/20 of a segment) that an offset along the surface by strain or
   * rounding explains it: the end's tangent goes on so far.
   * @param is_node a contactor node; a point between nodes is beside the end or
   * not, but for rounding
   */
  std::optional<CurveProjection>
  project_beyond_ends(const Curve            &curve,
                      const dealii::Point<2> &x,
                      const CurveQuery       &query,
                      const bool              is_node);

  /**
   * At a vertex the direction from y to x is no normal when the two nearly
   * coincide: an offset along the surface by rounding would turn it by 90
   * degrees. Within 1/20 of a segment the normal is the one of the vertex's
   * cone that is most opposed to that of the contactor.
   */
  void
  face_contactor(const Curve                &curve,
                 const dealii::Point<2>     &x,
                 const dealii::Tensor<1, 2> &contactor_normal,
                 CurveProjection            &vertex);

  /**
   * The normal n at a blunt joint (0.7 rad at most), as between two facets of a
   * smooth body: over 1/20 of a segment on both sides it turns from one to the
   * other, so that a contactor node that rests on the joint has a normal at
   * all. As far above the joint it goes over into that of the nearest point: on
   * and outside of a convex joint it has no jump.
   *
   * The gap is (x - y).n, zero where it was, and otherwise smaller by less than
   * 1 - cos(turn/2). What the rows take for its gradient is n: it differs from
   * that of the distance by half the turn at most. The gradient of (x - y).n
   * itself would not do, since at a closed contact it is that of the facet,
   * which jumps at the joint.
   *
   * True if the projection is so near to one; it then counts as a vertex,
   * without curvature.
   */
  bool
  round_joint(const Curve &curve, CurveProjection &projection);
} // namespace Signorini

#endif
