#include <signorini/input/instantiate.h>
#include <signorini/solid/nodal_interpolation.h>

#include <deal.II/base/bounding_box.h>
#include <deal.II/base/polynomial.h>
#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    // How far a point may be from its cell, in sizes of the cell.
    const double reach = 0.2;

    template <int dim>
    TensorProductPolynomials<dim>
    lagrange_polynomials(const unsigned int degree)
    {
      return TensorProductPolynomials<dim>(
        Polynomials::generate_complete_Lagrange_basis(
          QGaussLobatto<1>(degree + 1).get_points()));
    }

    template <int dim>
    Point<dim>
    clamped(Point<dim> unit_point, const double margin)
    {
      for (unsigned int d = 0; d < dim; ++d)
        unit_point[d] = std::clamp(unit_point[d], -margin, 1. + margin);
      return unit_point;
    }
  } // namespace



  template <int dim>
  NodalInterpolation<dim>::NodalInterpolation(NodalMesh<dim> mesh)
    : mesh_(std::move(mesh))
    , shapes_(lagrange_polynomials<dim>(mesh_.degree))
  {
    std::vector<std::pair<BoundingBox<dim>, unsigned int>> boxes;
    for (unsigned int cell = 0; cell < mesh_.n_cells(); ++cell)
      {
        std::vector<Point<dim>> points;
        for (unsigned int a = 0; a < shapes_.n(); ++a)
          points.push_back(mesh_.nodes[nodes_of(cell)[a]]);
        BoundingBox<dim> box(points);
        const auto      &corners = box.get_boundary_points();
        sizes_.push_back(corners.first.distance(corners.second) /
                         std::sqrt(double(dim)));
        // Curved edges leave the box of their nodes by less than that.
        box.extend(1.5 * reach * sizes_.back());
        boxes.emplace_back(box, cell);
      }
    tree_ = pack_rtree(boxes);
  }



  template <int dim>
  std::optional<InterpolationWeights>
  NodalInterpolation<dim>::weights(const Point<dim> &point) const
  {
    std::vector<std::pair<BoundingBox<dim>, unsigned int>> found;
    tree_.query(boost::geometry::index::intersects(point),
                std::back_inserter(found));
    std::optional<Place> best;
    for (const auto &[box, cell] : found)
      {
        const Place place = place_in(cell, point);
        if (place.distance <= reach * sizes_[cell] &&
            (!best || std::tie(place.distance, cell) <
                        std::tie(best->distance, best->cell)))
          best = place;
      }
    if (!best)
      return std::nullopt;

    InterpolationWeights result;
    result.nodes.assign(nodes_of(best->cell),
                        nodes_of(best->cell) + shapes_.n());
    const Point<dim> unit_point = clamped(best->unit_point, reach);
    for (unsigned int a = 0; a < shapes_.n(); ++a)
      result.weights.push_back(shapes_.compute_value(a, unit_point));
    return result;
  }



  template <int dim>
  bool
  NodalInterpolation<dim>::contains(const Point<dim> &point) const
  {
    std::vector<std::pair<BoundingBox<dim>, unsigned int>> found;
    tree_.query(boost::geometry::index::intersects(point),
                std::back_inserter(found));
    return std::any_of(found.begin(), found.end(), [&](const auto &box) {
      const Place    place = place_in(box.second, point);
      Tensor<2, dim> unused;
      // In a folded cell Newton's method may end anywhere.
      return place.distance == 0. &&
             point_at(box.second, place.unit_point, unused).distance(point) <
               1e-6 * sizes_[box.second];
    });
  }



  template <int dim>
  const Point<dim> &
  NodalInterpolation<dim>::node_near(const Point<dim> &point) const
  {
    return *std::min_element(mesh_.nodes.begin(),
                             mesh_.nodes.end(),
                             [&](const Point<dim> &a, const Point<dim> &b) {
                               return a.distance_square(point) <
                                      b.distance_square(point);
                             });
  }



  template <int dim>
  typename NodalInterpolation<dim>::Place
  NodalInterpolation<dim>::place_in(const unsigned int cell,
                                    const Point<dim>  &point) const
  {
    Place            place  = {cell, invert(cell, point), 0.};
    const Point<dim> inside = clamped(place.unit_point, 0.);
    if (place.unit_point.distance(inside) > 1e-10)
      {
        Tensor<2, dim> unused;
        place.distance = point_at(cell, inside, unused).distance(point);
      }
    return place;
  }



  template <int dim>
  Point<dim>
  NodalInterpolation<dim>::point_at(const unsigned int cell,
                                    const Point<dim>  &unit_point,
                                    Tensor<2, dim>    &gradient) const
  {
    Point<dim> point;
    gradient = 0.;
    for (unsigned int a = 0; a < shapes_.n(); ++a)
      {
        const Point<dim> &node = mesh_.nodes[nodes_of(cell)[a]];
        point += shapes_.compute_value(a, unit_point) * node;
        gradient += outer_product(static_cast<const Tensor<1, dim> &>(node),
                                  shapes_.compute_grad(a, unit_point));
      }
    return point;
  }



  template <int dim>
  Point<dim>
  NodalInterpolation<dim>::invert(const unsigned int cell,
                                  const Point<dim>  &point) const
  {
    Point<dim> unit_point;
    for (unsigned int d = 0; d < dim; ++d)
      unit_point[d] = 0.5;
    Tensor<2, dim> gradient;
    Tensor<1, dim> error = point - point_at(cell, unit_point, gradient);
    for (unsigned int iteration = 0; iteration < 30; ++iteration)
      {
        // Far outside the map may fold; such a cell is not the nearest one.
        if (determinant(gradient) <= 0.)
          break;
        Tensor<1, dim> step    = dealii::invert(gradient) * error;
        const bool     is_last = step.norm() < 1e-9; // then it is exact
        for (unsigned int halving = 0;; ++halving)
          {
            const Point<dim>     next = unit_point + step;
            const Tensor<1, dim> rest = point - point_at(cell, next, gradient);
            if (is_last || rest.norm() < error.norm() || halving == 10)
              {
                unit_point = next;
                error      = rest;
                break;
              }
            step *= 0.5;
          }
        if (is_last)
          break;
      }
    return unit_point;
  }



#define INSTANTIATE(dim) template class NodalInterpolation<dim>;
  SIGNORINI_FOR_EACH_DIMENSION(INSTANTIATE)
#undef INSTANTIATE
} // namespace Signorini
