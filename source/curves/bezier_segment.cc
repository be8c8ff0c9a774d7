#include <signorini/curves/bezier_segment.h>

#include <deal.II/base/quadrature_lib.h>

namespace Signorini
{
  using namespace dealii;

  std::array<double, 4>
  bernstein(const double xi)
  {
    const double eta = 1. - xi;
    return {
      {eta * eta * eta, 3. * eta * eta * xi, 3. * eta * xi * xi, xi * xi * xi}};
  }



  std::array<double, 4>
  bernstein_derivative(const double xi)
  {
    const double eta = 1. - xi;
    return {{-3. * eta * eta,
             3. * eta * (eta - 2. * xi),
             3. * xi * (2. * eta - xi),
             3. * xi * xi}};
  }



  BezierSegment
  BezierSegment::line(const Point<2> &start, const Point<2> &end)
  {
    return {
      {{start, start + (end - start) / 3., end - (end - start) / 3., end}}};
  }



  Point<2>
  BezierSegment::value(const double xi) const
  {
    const auto   weights = bernstein(xi);
    Tensor<1, 2> sum;
    for (unsigned int i = 0; i < 4; ++i)
      sum += weights[i] * control[i];
    return Point<2>(sum);
  }



  // From differences of the control points: exact zeros stay zeros.
  Tensor<1, 2>
  BezierSegment::derivative(const double xi) const
  {
    const double eta = 1. - xi;
    return 3. * (eta * eta * (control[1] - control[0]) +
                 2. * eta * xi * (control[2] - control[1]) +
                 xi * xi * (control[3] - control[2]));
  }



  Tensor<1, 2>
  BezierSegment::second_derivative(const double xi) const
  {
    const Tensor<1, 2> first  = control[1] - control[0];
    const Tensor<1, 2> second = control[2] - control[1];
    const Tensor<1, 2> third  = control[3] - control[2];
    return 6. * ((1. - xi) * (second - first) + xi * (third - second));
  }



  Tensor<1, 2>
  BezierSegment::tangent(const double xi) const
  {
    const Tensor<1, 2> slope = derivative(xi);
    const double       speed = slope.norm();
    const Tensor<1, 2> chord = control[3] - control[0];
    if (speed > 1e-14 * chord.norm() && speed > 0.)
      return slope / speed;
    for (const unsigned int i : {1u, 2u, 3u})
      {
        const Tensor<1, 2> towards =
          xi < 0.5 ? control[i] - control[0] : control[3] - control[3 - i];
        if (towards.norm() > 1e-14 * chord.norm() && towards.norm() > 0.)
          return towards / towards.norm();
      }
    Tensor<1, 2> any;
    any[0] = 1.;
    return any;
  }



  BoundingBox<2>
  BezierSegment::box() const
  {
    Point<2> lower = control[0], upper = control[0];
    for (const Point<2> &point : control)
      for (unsigned int d = 0; d < 2; ++d)
        {
          lower[d] = std::min(lower[d], point[d]);
          upper[d] = std::max(upper[d], point[d]);
        }
    return BoundingBox<2>({lower, upper});
  }



  namespace
  {
    double
    gauss_length(const BezierSegment &segment,
                 const double         start,
                 const double         end)
    {
      static const QGauss<1> gauss(8);
      double                 sum = 0.;
      for (unsigned int q = 0; q < gauss.size(); ++q)
        sum +=
          gauss.weight(q) *
          segment.derivative(start + (end - start) * gauss.point(q)[0]).norm();
      return sum * (end - start);
    }

    // Halves until both halves say what the whole says.
    double
    adaptive_length(const BezierSegment &segment,
                    const double         start,
                    const double         end,
                    const double         whole,
                    const unsigned int   depth)
    {
      const double middle = 0.5 * (start + end);
      const double left   = gauss_length(segment, start, middle);
      const double right  = gauss_length(segment, middle, end);
      if (depth == 0 || std::abs(left + right - whole) <= 1e-13 * whole)
        return left + right;
      return adaptive_length(segment, start, middle, left, depth - 1) +
             adaptive_length(segment, middle, end, right, depth - 1);
    }
  } // namespace



  double
  BezierSegment::length() const
  {
    return adaptive_length(*this, 0., 1., gauss_length(*this, 0., 1.), 20);
  }



  // De Casteljau's algorithm.
  std::pair<BezierSegment, BezierSegment>
  BezierSegment::split(const double xi) const
  {
    std::array<Point<2>, 4> points = control;
    BezierSegment           before, after;
    before.control[0] = points[0];
    after.control[3]  = points[3];
    for (unsigned int level = 1; level < 4; ++level)
      {
        for (unsigned int i = 0; i < 4 - level; ++i)
          points[i] = points[i] + xi * (points[i + 1] - points[i]);
        before.control[level]    = points[0];
        after.control[3 - level] = points[3 - level];
      }
    return {before, after};
  }
} // namespace Signorini
