#include <signorini/curves/bernstein_roots.h>
#include <signorini/curves/curve_projection.h>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    // Below this angle (rad) a joint is no vertex: what rounding leaves of a
    // smooth one would pretend a huge curvature.
    constexpr double least_turn = 1e-6;

    // A normal cone: the tangents on both sides of a point of the curve.
    struct Cone
    {
      Tensor<1, 2> before;
      Tensor<1, 2> after;
    };

    // The distance from x falls towards the point on both sides.
    bool
    holds(const Cone &cone, const Tensor<1, 2> &arm, const double tolerance)
    {
      return arm * cone.before >= -tolerance && arm * cone.after <= tolerance;
    }

    // The middle of the cone, out of the body.
    Tensor<1, 2>
    middle(const Cone &cone)
    {
      const Tensor<1, 2> sum =
        normal_of_tangent(cone.before) + normal_of_tangent(cone.after);
      // A corner that turns right back has only this direction.
      const Tensor<1, 2> along = cone.before - cone.after;
      return sum.norm() > least_turn ? sum / sum.norm() : along / along.norm();
    }

    CurveProjection
    vertex_at(const Curve          &curve,
              const CurveParameter &place,
              const Point<2>       &x,
              const Cone           &cone)
    {
      CurveProjection    result = projection_at(curve, place, x);
      const Tensor<1, 2> arm    = x - result.point;
      const double       size   = arm.norm();
      result.is_vertex          = true;
      result.normal             = middle(cone);
      if (size > 1e-13 * result.point.norm() && size > 0.)
        result.normal = (arm * result.normal < 0. ? -arm : arm) / size;
      result.gap       = arm * result.normal;
      result.tangent   = tangent_of_normal(result.normal);
      result.curvature = 0.;
      return result;
    }

    void
    add_joint(const Curve                  &curve,
              const unsigned int            s,
              const Point<2>               &x,
              std::vector<CurveProjection> &places)
    {
      const BezierSegment &before = curve.segment(s);
      const Cone           cone   = {before.tangent(1.),
                                     curve.segment(curve.next(s)).tangent(0.)};
      const Tensor<1, 2>   arm    = x - before.control[3];
      const double         size =
        arm.norm() + (before.control[3] - before.control[0]).norm();
      if (!holds(cone, arm, 1e-12 * size))
        return;
      if ((cone.before - cone.after).norm() > least_turn)
        places.push_back(vertex_at(curve, {s, 1.}, x, cone));
      else
        places.push_back(projection_at(curve, {s, 1.}, x));
    }

    // @param which 0: the start of an open curve, 1: its end
    void
    add_end(const Curve                  &curve,
            const unsigned int            which,
            const Point<2>               &x,
            std::vector<CurveProjection> &places)
    {
      const CurveParameter place   = which == 0 ?
                                       CurveParameter{0, 0.} :
                                       CurveParameter{curve.n_segments() - 1, 1.};
      const BezierSegment &segment = curve.segment(place.segment);
      const Tensor<1, 2>   tangent = curve.tangent(place);
      const Tensor<1, 2>   arm     = x - curve.value(place);
      const double    chord  = (segment.control[3] - segment.control[0]).norm();
      const double    beyond = arm * tangent * (which == 0 ? -1. : 1.);
      const double    tolerance = 1e-12 * (chord + arm.norm());
      const CurveEnd &end       = curve.end(which);
      if (beyond < -tolerance)
        return;
      if (end.kind == CurveEndKind::symmetric || beyond <= 1e-6 * chord)
        places.push_back(projection_at(curve, place, x));
      else if (end.kind == CurveEndKind::corner)
        {
          const Tensor<1, 2> other = tangent_of_normal(end.normal);
          const Cone         cone =
            which == 0 ? Cone{other, tangent} : Cone{tangent, other};
          if (holds(cone, arm, tolerance))
            places.push_back(vertex_at(curve, place, x, cone));
        }
    }

    // (y - x).y' in Bernstein form.
    std::array<double, 6>
    falling_distance(const BezierSegment &segment, const Point<2> &x)
    {
      constexpr double      cubic[]     = {1., 3., 3., 1.};
      constexpr double      quadratic[] = {1., 2., 1.};
      constexpr double      quintic[]   = {1., 5., 10., 10., 5., 1.};
      std::array<double, 6> result{};
      for (unsigned int i = 0; i < 4; ++i)
        for (unsigned int j = 0; j < 3; ++j)
          result[i + j] += cubic[i] * quadratic[j] / quintic[i + j] *
                           ((segment.control[i] - x) *
                            (segment.control[j + 1] - segment.control[j]));
      return result;
    }
  } // namespace



  CurveProjection
  projection_at(const Curve          &curve,
                const CurveParameter &place,
                const Point<2>       &x)
  {
    const BezierSegment &segment = curve.segment(place.segment);
    CurveProjection      result;
    result.segment   = place.segment;
    result.xi        = place.xi;
    result.point     = segment.value(place.xi);
    result.tangent   = segment.tangent(place.xi);
    result.normal    = normal_of_tangent(result.tangent);
    result.gap       = (x - result.point) * result.normal;
    result.is_vertex = false;
    result.speed     = segment.derivative(place.xi).norm();
    result.curvature = segment.second_derivative(place.xi) * result.normal;
    return result;
  }



  void
  find_nearest_places(const Curve                  &curve,
                      const unsigned int            s,
                      const Point<2>               &x,
                      std::vector<CurveProjection> &places)
  {
    const BezierSegment &segment = curve.segment(s);
    const double chord = (segment.control[3] - segment.control[0]).norm();
    // What rounding makes of a distance that is the same everywhere, as from
    // the centre of a circle.
    const double negligible =
      1e-15 * chord * ((segment.control[0] - x).norm() + chord);
    std::vector<double> roots;
    rising_roots(falling_distance(segment, x), negligible, roots);
    for (const double xi : roots)
      places.push_back(projection_at(curve, {s, xi}, x));

    if (curve.has_next(s))
      add_joint(curve, s, x, places);
    else
      add_end(curve, 1, x, places);
    if (!curve.has_previous(s))
      add_end(curve, 0, x, places);
  }
} // namespace Signorini
