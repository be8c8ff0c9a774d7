#include <signorini/geometry/gears/tooth_manifold.h>

namespace Signorini
{
  using namespace dealii;

  ToothManifold::ToothManifold(const RowProfile &profile)
    : profile(profile)
  {}



  std::unique_ptr<Manifold<2>>
  ToothManifold::clone() const
  {
    return std::make_unique<ToothManifold>(profile);
  }



  Point<2>
  ToothManifold::get_new_point(const ArrayView<const Point<2>> &points,
                               const ArrayView<const double>   &weights) const
  {
    const double first = profile.closest(points[0]);
    double       mean  = 0.;
    for (unsigned int i = 1; i < points.size(); ++i)
      mean += weights[i] * profile.way(first, profile.closest(points[i]));
    return profile.at(first + mean);
  }



  Tensor<1, 2>
  ToothManifold::get_tangent_vector(const Point<2> &from,
                                    const Point<2> &to) const
  {
    const double start = profile.closest(from);
    return profile.way(start, profile.closest(to)) * profile.tangent_at(start);
  }
} // namespace Signorini
