#ifndef signorini_geometry_boundary_distance_h
#define signorini_geometry_boundary_distance_h

#include <deal.II/base/point.h>
#include <deal.II/base/types.h>
#include <deal.II/grid/tria.h>
#include <deal.II/numerics/rtree.h>

#include <array>
#include <vector>

namespace Signorini
{
  /**
   * The distance of points from the active faces with one boundary id. Faces
   * are straight between their vertices; in 3-D they are two triangles.
   */
  template <int dim>
  class BoundaryDistance
  {
  public:
    BoundaryDistance(const dealii::Triangulation<dim> &triangulation,
                     const dealii::types::boundary_id  boundary);

    /**
     * Is a face within this distance of the point? Rounding errors do not
     * matter: 1e-10 of the distance is allowed.
     */
    bool
    is_within(const dealii::Point<dim> &point, const double distance) const;

  private:
    /** A segment or a triangle. */
    using Piece = std::array<dealii::Point<dim>, dim>;

    std::vector<Piece>                                               pieces;
    dealii::RTree<std::pair<dealii::BoundingBox<dim>, unsigned int>> tree;
  };

  /** Distance of @p p from the segment between a and b. */
  template <int dim>
  double
  distance_from(const std::array<dealii::Point<dim>, 2> &segment,
                const dealii::Point<dim>                &p);

  /** Distance of @p p from a triangle. */
  double
  distance_from(const std::array<dealii::Point<3>, 3> &triangle,
                const dealii::Point<3>                &p);
} // namespace Signorini

#endif
