#include <signorini/curves/corner_normals.h>

#include <algorithm>
#include <cmath>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    // In parts of a segment: so near to a vertex a point is taken as at it.
    constexpr double near_vertex = 0.05;

    // The same for what is at an open end but for rounding.
    constexpr double rounding_at_end = 1e-9;

    // The normals on both sides of a vertex, in the order of the curve.
    std::array<Tensor<1, 2>, 2>
    normal_cone(const Curve &curve, const CurveProjection &vertex)
    {
      const unsigned int s        = vertex.segment;
      const bool         at_start = vertex.xi < 0.5;
      const Tensor<1, 2> own      = curve.normal(vertex.place());
      if (at_start)
        return {{curve.has_previous(s) ? curve.normal({curve.previous(s), 1.}) :
                                         curve.end(0).normal,
                 own}};
      return {{own,
               curve.has_next(s) ? curve.normal({curve.next(s), 0.}) :
                                   curve.end(1).normal}};
    }

    // Joints that turn by less are those of facets on a smooth body.
    constexpr double blunt = 0.7; // rad
  }                               // namespace



  std::optional<CurveProjection>
  project_beyond_ends(const Curve      &curve,
                      const Point<2>   &x,
                      const CurveQuery &query,
                      const bool        is_node)
  {
    const double allowance = is_node ? near_vertex : rounding_at_end;
    if (curve.is_closed())
      return {};
    for (const CurveParameter end :
         {CurveParameter{0, 0.}, CurveParameter{curve.n_segments() - 1, 1.}})
      {
        CurveProjection projection = projection_at(curve, end, x);
        const double    offset = (x - projection.point) * projection.tangent *
                              (end.xi > 0. ? 1. : -1.);
        if (offset < 0. ||
            offset > allowance * curve.segment(end.segment).length() ||
            projection.gap > query.search_distance ||
            projection.gap < -query.penetration_limit ||
            (query.contactor_normal &&
             *query.contactor_normal * projection.normal >
               query.maximal_cosine))
          continue;
        projection.is_vertex = true;
        return projection;
      }
    return {};
  }



  void
  face_contactor(const Curve        &curve,
                 const Point<2>     &x,
                 const Tensor<1, 2> &contactor_normal,
                 CurveProjection    &vertex)
  {
    const double size = curve.segment(vertex.segment).length();
    const auto   cone = normal_cone(curve, vertex);
    if (contactor_normal.norm() == 0. || cone[0].norm() == 0. ||
        cone[1].norm() == 0.)
      return;
    const auto cross = [](const Tensor<1, 2> &a, const Tensor<1, 2> &b) {
      return a[0] * b[1] - a[1] * b[0];
    };
    // A reentrant corner has no cone.
    const double orientation = cross(cone[0], cone[1]);
    if (orientation <= 0.)
      return;
    const Tensor<1, 2> facing = -contactor_normal;
    const Tensor<1, 2> normal =
      cross(cone[0], facing) >= 0. && cross(facing, cone[1]) >= 0. ? facing :
      facing * cone[0] > facing * cone[1]                          ? cone[0] :
                                                                     cone[1];
    const Tensor<1, 2> arm = x - vertex.point;
    const double       gap = arm * normal;
    if ((arm - gap * normal).norm() > near_vertex * size)
      return;
    vertex.normal    = normal;
    vertex.tangent   = tangent_of_normal(normal);
    vertex.gap       = gap;
    vertex.curvature = 0.;
  }



  bool
  round_joint(const Curve &curve, CurveProjection &projection)
  {
    const unsigned int s        = projection.segment;
    const bool         at_start = projection.xi < 0.5;
    if (at_start ? !curve.has_previous(s) : !curve.has_next(s))
      return false;
    const double part = at_start ? projection.xi : 1. - projection.xi;
    if (part >= near_vertex)
      return false;
    const unsigned int beside = at_start ? curve.previous(s) : curve.next(s);
    const Tensor<1, 2> own    = curve.normal({s, at_start ? 0. : 1.});
    const Tensor<1, 2> other  = curve.normal({beside, at_start ? 1. : 0.});
    const double       turn   = angle_between(own, other);
    // Near across the curve, too: the normal at a vertex is right from afar.
    const double size     = near_vertex * std::min(curve.segment(s).length(),
                                               curve.segment(beside).length());
    const double nearness = 1. - std::abs(projection.gap) / size;
    if (turn < 1e-6 || turn > blunt || nearness <= 0.)
      return false;

    const double share  = 0.5 * (1. + part / near_vertex);
    Tensor<1, 2> normal = share * own + (1. - share) * other;
    normal =
      nearness / normal.norm() * normal + (1. - nearness) * projection.normal;
    normal /= normal.norm();
    projection.gap *= projection.normal * normal;
    projection.normal    = normal;
    projection.tangent   = tangent_of_normal(normal);
    projection.is_vertex = true;
    projection.curvature = 0.;
    return true;
  }
} // namespace Signorini
