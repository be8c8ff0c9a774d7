#include <signorini/curves/curve.h>
#include <signorini/curves/smooth_parts.h>
#include <signorini/input/input_error.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <sstream>

namespace Signorini
{
  using namespace dealii;

  std::vector<bool>
  corners_of_polygon(const std::vector<Point<2>> &points,
                     const bool                   is_closed,
                     const double                 feature_angle)
  {
    const double       angle      = feature_angle * numbers::PI / 180.;
    const unsigned int n          = points.size();
    const unsigned int n_segments = is_closed ? n : n - 1;
    std::vector<bool>  is_corner(n_segments, false);
    for (unsigned int s = 0; s < n_segments; ++s)
      if (is_closed || s + 1 < n_segments)
        is_corner[s] =
          angle_between(points[(s + 1) % n] - points[s],
                        points[(s + 2) % n] - points[(s + 1) % n]) > angle;
    return is_corner;
  }



  std::vector<SmoothPart>
  smooth_parts(const std::vector<bool> &is_corner, const bool is_closed)
  {
    const unsigned int n = is_corner.size();
    // A closed chain is walked from a corner, if it has one.
    unsigned int first = 0;
    if (is_closed)
      {
        const auto corner = std::find(is_corner.begin(), is_corner.end(), true);
        if (corner == is_corner.end())
          return {{0, n, true}};
        first = corner - is_corner.begin() + 1;
      }
    std::vector<SmoothPart> parts;
    for (unsigned int walked = 0; walked < n;)
      {
        unsigned int count = 1;
        while (walked + count < n &&
               !is_corner[(first + walked + count - 1) % n])
          ++count;
        parts.push_back({(first + walked) % n, count, false});
        walked += count;
      }
    return parts;
  }



  void
  check_polygon(const std::vector<Point<2>> &points, const bool is_closed)
  {
    const unsigned int n     = points.size();
    const unsigned int least = is_closed ? 3 : 2;
    if (n < least)
      throw InputError(std::string(is_closed ? "a closed" : "an open") +
                       " curve needs at least " + std::to_string(least) +
                       " points, found " + std::to_string(n) + ".");
    for (unsigned int i = 0; i < (is_closed ? n : n - 1); ++i)
      if (points[i].distance(points[(i + 1) % n]) == 0.)
        {
          std::ostringstream message;
          message << "points " << i + 1 << " and " << (i + 1) % n + 1
                  << " lie at the same place, (" << points[i][0] << ", "
                  << points[i][1] << "), in m; leave out one of them"
                  << (is_closed && i + 1 == n ?
                        ": a closed curve does not repeat its first point." :
                        ".");
          throw InputError(message.str());
        }
  }
} // namespace Signorini
