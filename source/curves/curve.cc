#include <signorini/curves/curve.h>

#include <deal.II/base/numbers.h>
#include <deal.II/base/quadrature_lib.h>

#include <utility>

namespace Signorini
{
  using namespace dealii;

  Curve::Curve(std::vector<BezierSegment>     segments,
               std::vector<bool>              is_corner,
               const bool                     is_closed,
               const std::array<CurveEnd, 2> &ends)
    : segments_(std::move(segments))
    , is_corner_(std::move(is_corner))
    , is_closed_(is_closed)
    , ends_(ends)
  {
    AssertDimension(segments_.size(), is_corner_.size());
  }



  Tensor<1, 2>
  Curve::normal(const CurveParameter &place) const
  {
    return normal_of_tangent(tangent(place));
  }



  double
  Curve::length() const
  {
    double sum = 0.;
    for (const auto &segment : segments_)
      sum += segment.length();
    return sum;
  }



  // Green's theorem, 1/2 int y x y' dxi, a polynomial of degree 5.
  double
  Curve::enclosed_area() const
  {
    const QGauss<1> gauss(3);
    double          sum = 0.;
    // Seen from a point of the curve, to lose no digits far from the origin.
    const Point<2> origin = segments_[0].control[0];
    for (const auto &segment : segments_)
      for (unsigned int q = 0; q < gauss.size(); ++q)
        {
          const double       xi    = gauss.point(q)[0];
          const Tensor<1, 2> y     = segment.value(xi) - origin;
          const Tensor<1, 2> slope = segment.derivative(xi);
          sum += 0.5 * gauss.weight(q) * (y[0] * slope[1] - y[1] * slope[0]);
        }
    return sum;
  }



  Curve
  Curve::reversed() const
  {
    const unsigned int         n = n_segments();
    std::vector<BezierSegment> segments(n);
    std::vector<bool>          is_corner(n, false);
    for (unsigned int s = 0; s < n; ++s)
      {
        for (unsigned int i = 0; i < 4; ++i)
          segments[s].control[i] = segments_[n - 1 - s].control[3 - i];
        // The joint after s is the one after its successor of before.
        is_corner[s] = is_corner_[s + 1 < n ? n - 2 - s : n - 1];
      }
    std::array<CurveEnd, 2> ends = {{ends_[1], ends_[0]}};
    for (auto &end : ends)
      end.normal *= -1.;
    return Curve(std::move(segments), std::move(is_corner), is_closed_, ends);
  }



  Curve
  Curve::moved(const Tensor<2, 2> &rotation,
               const Tensor<1, 2> &translation) const
  {
    Curve result = *this;
    for (auto &segment : result.segments_)
      for (auto &point : segment.control)
        point = Point<2>(rotation * Tensor<1, 2>(point) + translation);
    for (auto &end : result.ends_)
      end.normal = rotation * end.normal;
    return result;
  }



  Tensor<1, 2>
  normal_of_tangent(const Tensor<1, 2> &tangent)
  {
    Tensor<1, 2> normal;
    normal[0] = tangent[1];
    normal[1] = -tangent[0];
    return normal;
  }



  Tensor<1, 2>
  tangent_of_normal(const Tensor<1, 2> &normal)
  {
    return -normal_of_tangent(normal);
  }



  double
  angle_between(const Tensor<1, 2> &a, const Tensor<1, 2> &b)
  {
    return std::abs(std::atan2(a[0] * b[1] - a[1] * b[0], a * b));
  }



  std::vector<bool>
  corners_between(const std::vector<BezierSegment> &segments,
                  const bool                        is_closed,
                  const double                      feature_angle)
  {
    const double      angle = feature_angle * numbers::PI / 180.;
    std::vector<bool> result(segments.size(), false);
    for (unsigned int s = 0; s < segments.size(); ++s)
      if (is_closed || s + 1 < segments.size())
        {
          const auto &next = segments[s + 1 < segments.size() ? s + 1 : 0];
          result[s] =
            angle_between(segments[s].tangent(1.), next.tangent(0.)) > angle;
        }
    return result;
  }
} // namespace Signorini
