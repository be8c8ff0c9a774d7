#include <signorini/geometry/polyline.h>
#include <signorini/geometry/shapes/block.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <cmath>

namespace Signorini
{
  using namespace dealii;

  std::vector<double>
  growing_fractions(const unsigned int n, const double first)
  {
    // The first size falls as the ratio of last to first grows.
    double low = 1., high = 50.;
    if (n == 1 || first * n >= 1.)
      return equal_fractions(n);
    for (unsigned int i = 0; i < 60; ++i)
      {
        const double middle = 0.5 * (low + high);
        (graded_points(0., 1., n, middle)[1] > first ? low : high) = middle;
      }
    return graded_points(0., 1., n, 0.5 * (low + high));
  }



  std::vector<double>
  equal_fractions(const unsigned int n)
  {
    return graded_points(0., 1., n, 1.);
  }



  Polyline
  straight_line(const Point<2>            &start,
                const Point<2>            &end,
                const std::vector<double> &fractions)
  {
    Polyline line;
    for (const double fraction : fractions)
      line.push_back(start + fraction * (end - start));
    line.back() = end;
    return line;
  }



  Polyline
  arc(const Point<2>            &start,
      const Point<2>            &end,
      const Point<2>            &center,
      const std::vector<double> &fractions)
  {
    const Tensor<1, 2> from = start - center, to = end - center;
    const double       turn =
      std::atan2(from[0] * to[1] - from[1] * to[0], from * to);

    Polyline line;
    for (const double fraction : fractions)
      {
        const double c = std::cos(fraction * turn);
        const double s = std::sin(fraction * turn);
        line.push_back(center + Tensor<1, 2>({c * from[0] - s * from[1],
                                              s * from[0] + c * from[1]}));
      }
    line.front() = start;
    line.back()  = end;
    return line;
  }



  Polyline
  parabola(const Point<2>            &start,
           const Point<2>            &control,
           const Point<2>            &end,
           const std::vector<double> &fractions)
  {
    const auto point = [&](const double t) {
      return start + 2. * t * (1. - t) * (control - start) +
             t * t * (end - start);
    };
    // The parameter is not the length: it is looked up in a fine polygon.
    const unsigned int n_pieces = 64;
    Polyline           polygon;
    for (unsigned int i = 0; i <= n_pieces; ++i)
      polygon.push_back(point(i / double(n_pieces)));
    const std::vector<double> lengths = positions_along(polygon);

    Polyline     line;
    unsigned int i = 0;
    for (const double fraction : fractions)
      {
        while (i + 1 < n_pieces && lengths[i + 1] < fraction)
          ++i;
        const double rest =
          (fraction - lengths[i]) / (lengths[i + 1] - lengths[i]);
        line.push_back(point((i + rest) / n_pieces));
      }
    line.front() = start;
    line.back()  = end;
    return line;
  }



  Polyline
  reversed(const Polyline &line)
  {
    return Polyline(line.rbegin(), line.rend());
  }



  Point<2>
  mirrored(const Point<2> &point)
  {
    return Point<2>(-point[0], point[1]);
  }



  Polyline
  mirrored(Polyline line)
  {
    for (Point<2> &point : line)
      point = mirrored(point);
    return line;
  }



  Polyline
  joined(const Polyline &first, const Polyline &second)
  {
    AssertThrow(first.back() == second.front(), ExcInternalError());
    Polyline line = first;
    line.insert(line.end(), second.begin() + 1, second.end());
    return line;
  }



  std::vector<double>
  positions_along(const Polyline &line)
  {
    std::vector<double> positions = {0.};
    for (unsigned int i = 1; i < line.size(); ++i)
      positions.push_back(positions.back() + line[i].distance(line[i - 1]));
    for (double &position : positions)
      position /= positions.back();
    return positions;
  }
} // namespace Signorini
