#include <signorini/geometry/degrees.h>

#include <deal.II/base/numbers.h>

#include <cmath>

namespace Signorini
{
  using namespace dealii;

  double
  cos_degrees(const double angle)
  {
    const double quarters = angle / 90.;
    if (quarters != std::floor(quarters))
      return std::cos(angle * numbers::PI / 180.);
    const int turn = (static_cast<int>(std::fmod(quarters, 4.)) + 4) % 4;
    return turn == 0 ? 1. : turn == 2 ? -1. : 0.;
  }



  double
  sin_degrees(const double angle)
  {
    const double quarters = angle / 90.;
    return quarters == std::floor(quarters) ?
             cos_degrees(angle - 90.) :
             std::sin(angle * numbers::PI / 180.);
  }
} // namespace Signorini
