#include <signorini/geometry/neighbourhood.h>

#include <deal.II/base/patterns.h>
#include <deal.II/base/utilities.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace Signorini
{
  using namespace dealii;

  template <int dim>
  bool
  Neighbourhood<dim>::is_reached_by(const BoundingBox<dim> &box) const
  {
    Tensor<1, dim> outside;
    for (unsigned int d = 0; d < dim; ++d)
      outside[d] = std::max(
        {box.lower_bound(d) - center[d], 0., center[d] - box.upper_bound(d)});
    return outside.norm() <= radius;
  }



  template <int dim>
  std::optional<Neighbourhood<dim>>
  parse_neighbourhood(const std::string &center, const std::string &radius)
  {
    const std::vector<std::string> coordinates =
      Utilities::split_string_list(center, ',');
    Neighbourhood<dim> result;
    result.radius = number_or_nan(radius);
    if (coordinates.size() != dim || !(result.radius >= 0.))
      return std::nullopt;
    for (unsigned int d = 0; d < dim; ++d)
      {
        result.center[d] = number_or_nan(coordinates[d]);
        if (!std::isfinite(result.center[d]))
          return std::nullopt;
      }
    return result;
  }



  double
  number_or_nan(const std::string &text)
  {
    return Patterns::Double().match(text) ?
             Utilities::string_to_double(text) :
             std::numeric_limits<double>::quiet_NaN();
  }

  template struct Neighbourhood<2>;
  template struct Neighbourhood<3>;
  template std::optional<Neighbourhood<2>>
  parse_neighbourhood<2>(const std::string &, const std::string &);
  template std::optional<Neighbourhood<3>>
  parse_neighbourhood<3>(const std::string &, const std::string &);
} // namespace Signorini
