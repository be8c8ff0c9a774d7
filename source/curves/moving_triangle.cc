#include <signorini/curves/bernstein_roots.h>
#include <signorini/curves/moving_triangle.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    // Edges b - a and c - a, and the arm from a to the point.
    struct Frame
    {
      Tensor<1, 3> first, second, arm;

      Tensor<1, 3>
      normal() const
      {
        return cross_product_3d(first, second);
      }

      double
      distance() const
      {
        const double area = normal().norm();
        return area > 0. ? arm * normal() / area : 0.;
      }

      // With some room, so that nothing slips through between two triangles.
      bool
      is_inside() const
      {
        constexpr double   room   = 1e-9;
        const Tensor<1, 3> n      = normal();
        const double       square = n.norm_square();
        if (square == 0.)
          return false;
        const double u = cross_product_3d(arm, second) * n / square;
        const double v = cross_product_3d(first, arm) * n / square;
        return std::min({u, v, 1. - u - v}) > -room;
      }
    };

    Frame
    frame(const Point<3> &point, const std::array<Point<3>, 3> &corners)
    {
      return {corners[1] - corners[0],
              corners[2] - corners[0],
              point - corners[0]};
    }

    Frame
    between(const Frame &start, const Frame &end, const double t)
    {
      return {(1. - t) * start.first + t * end.first,
              (1. - t) * start.second + t * end.second,
              (1. - t) * start.arm + t * end.arm};
    }

    double
    volume(const Frame &arm, const Frame &first, const Frame &second)
    {
      return arm.arm * cross_product_3d(first.first, second.second);
    }

    // When arm . first x second falls through zero.
    std::vector<double>
    instants_of_entry(const Frame &start, const Frame &end)
    {
      const Frame &s = start, &e = end;
      const double c0 = -volume(s, s, s), c3 = -volume(e, e, e);
      const double c1 =
        -(volume(e, s, s) + volume(s, e, s) + volume(s, s, e)) / 3.;
      const double c2 =
        -(volume(s, e, e) + volume(e, s, e) + volume(e, e, s)) / 3.;
      const double largest =
        std::max({std::abs(c0), std::abs(c1), std::abs(c2), std::abs(c3)});
      // The same cubic with two degrees more.
      std::vector<double> times;
      rising_roots({{c0,
                     (2. * c0 + 3. * c1) / 5.,
                     (c0 + 6. * c1 + 3. * c2) / 10.,
                     (3. * c1 + 6. * c2 + c3) / 10.,
                     (3. * c2 + 2. * c3) / 5.,
                     c3}},
                   1e-15 * largest,
                   times);
      return times;
    }

    // How far below the triangle the point comes after it entered.
    double
    depth(const Frame &start, const Frame &end, const double entry)
    {
      constexpr unsigned int n_samples = 16;
      double                 deepest   = 0.;
      for (unsigned int i = 1; i <= n_samples; ++i)
        {
          const double t        = entry + i * (1. - entry) / n_samples;
          const double distance = between(start, end, t).distance();
          if (distance > 0.)
            break;
          deepest = std::max(deepest, -distance);
        }
      return deepest;
    }
  } // namespace



  bool
  passes(const Point<3>       &start,
         const Point<3>       &end,
         const MovingTriangle &triangle,
         const double          tolerance)
  {
    const Frame first = frame(start, triangle.start);
    const Frame last  = frame(end, triangle.end);
    const auto  times = instants_of_entry(first, last);
    return std::any_of(times.begin(), times.end(), [&](const double t) {
      return between(first, last, t).is_inside() &&
             depth(first, last, t) > tolerance;
    });
  }
} // namespace Signorini
