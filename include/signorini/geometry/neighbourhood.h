#ifndef signorini_geometry_neighbourhood_h
#define signorini_geometry_neighbourhood_h

#include <deal.II/base/bounding_box.h>
#include <deal.II/base/point.h>

#include <optional>
#include <string>

namespace Signorini
{
  /** A circle or sphere with its inside. */
  template <int dim>
  struct Neighbourhood
  {
    dealii::Point<dim> center; // m
    double             radius; // m

    /** Is a point of the box inside or on the border? */
    bool
    is_reached_by(const dealii::BoundingBox<dim> &box) const;
  };

  /**
   * Reads `x, y` or `x, y, z` and a radius. Nothing when a number is missing,
   * superfluous or no number, or when the radius is negative.
   */
  template <int dim>
  std::optional<Neighbourhood<dim>>
  parse_neighbourhood(const std::string &center, const std::string &radius);

  /** A number, or NaN, which no comparison accepts. */
  double
  number_or_nan(const std::string &text);
} // namespace Signorini

#endif
