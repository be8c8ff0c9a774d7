#include <signorini/geometry/boundary_distance.h>
#include <signorini/input/instantiate.h>

#include <deal.II/base/bounding_box.h>
#include <deal.II/grid/tria_accessor.h>

#include <algorithm>
#include <cmath>

namespace Signorini
{
  using namespace dealii;

  template <int dim>
  BoundaryDistance<dim>::BoundaryDistance(
    const Triangulation<dim> &triangulation,
    const types::boundary_id  boundary)
  {
    for (const auto &face : triangulation.active_face_iterators())
      if (face->at_boundary() && face->boundary_id() == boundary)
        {
          if constexpr (dim == 2)
            pieces.push_back({{face->vertex(0), face->vertex(1)}});
          else
            {
              pieces.push_back(
                {{face->vertex(0), face->vertex(1), face->vertex(2)}});
              pieces.push_back(
                {{face->vertex(3), face->vertex(1), face->vertex(2)}});
            }
        }

    std::vector<std::pair<BoundingBox<dim>, unsigned int>> boxes;
    for (unsigned int i = 0; i < pieces.size(); ++i)
      boxes.emplace_back(BoundingBox<dim>(std::vector<Point<dim>>(
                           pieces[i].begin(), pieces[i].end())),
                         i);
    tree = pack_rtree(boxes);
  }



  template <int dim>
  bool
  BoundaryDistance<dim>::is_within(const Point<dim> &point,
                                   const double      distance) const
  {
    namespace bgi = boost::geometry::index;

    const double allowed = (1. + 1e-10) * distance;
    Point<dim>   lower = point, upper = point;
    for (unsigned int d = 0; d < dim; ++d)
      {
        lower[d] -= allowed;
        upper[d] += allowed;
      }
    const BoundingBox<dim> surroundings(std::make_pair(lower, upper));
    for (auto box = tree.qbegin(bgi::intersects(surroundings));
         box != tree.qend();
         ++box)
      if (distance_from(pieces[box->second], point) <= allowed)
        return true;
    return false;
  }



  template <int dim>
  double
  distance_from(const std::array<Point<dim>, 2> &segment, const Point<dim> &p)
  {
    const Tensor<1, dim> direction = segment[1] - segment[0];
    const double         position =
      std::clamp((p - segment[0]) * direction / direction.norm_square(),
                 0.,
                 1.);
    return p.distance(segment[0] + position * direction);
  }



  double
  distance_from(const std::array<Point<3>, 3> &triangle, const Point<3> &p)
  {
    const Tensor<1, 3> normal =
      cross_product_3d(triangle[1] - triangle[0], triangle[2] - triangle[0]);

    // Above the inside of the triangle all three products are positive.
    bool   inside  = true;
    double nearest = p.distance(triangle[0]);
    for (unsigned int i = 0; i < 3; ++i)
      {
        const Point<3>     a = triangle[i], b = triangle[(i + 1) % 3];
        const Tensor<1, 3> inward = cross_product_3d(normal, b - a);
        inside                    = inside && (p - a) * inward >= 0.;
        nearest = std::min(nearest, distance_from<3>({{a, b}}, p));
      }
    return inside ? std::abs((p - triangle[0]) * normal) / normal.norm() :
                    nearest;
  }

#define INSTANTIATE(dim)                                                \
  template class BoundaryDistance<dim>;                                 \
  template double distance_from<dim>(const std::array<Point<dim>, 2> &, \
                                     const Point<dim> &);
  SIGNORINI_FOR_EACH_DIMENSION(INSTANTIATE)
#undef INSTANTIATE
} // namespace Signorini
