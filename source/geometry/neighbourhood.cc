#include <signorini/geometry/neighbourhood.h>
#include <signorini/input/instantiate.h>
#include <signorini/input/named_list.h>

#include <deal.II/base/patterns.h>
#include <deal.II/base/utilities.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
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
    constexpr double no_number = std::numeric_limits<double>::quiet_NaN();
    if (!Patterns::Double().match(text))
      return no_number;
    // What vanishes beside all measures is none either.
    const double value = std::strtod(text.c_str(), nullptr);
    return is_sane(value) ? value : no_number;
  }

#define INSTANTIATE(dim)                                               \
  template struct Neighbourhood<dim>;                                  \
  template std::optional<Neighbourhood<dim>> parse_neighbourhood<dim>( \
    const std::string &, const std::string &);
  SIGNORINI_FOR_EACH_DIMENSION(INSTANTIATE)
#undef INSTANTIATE
} // namespace Signorini
