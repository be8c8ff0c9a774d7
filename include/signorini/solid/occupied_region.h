#ifndef signorini_solid_occupied_region_h
#define signorini_solid_occupied_region_h

#include <signorini/linear_algebra/types.h>
#include <signorini/solid/body.h>
#include <signorini/solid/nodal_interpolation.h>
#include <signorini/solid/surface_pieces.h>

#include <optional>
#include <vector>

namespace Signorini
{
  /**
   * The part of space that a body takes up under a displacement: its cells, and
   * its whole boundary in straight or bilinear pieces between nodes.
   */
  template <int dim>
  class OccupiedRegion
  {
  public:
    OccupiedRegion(const Body<dim> &body, const DofVector &displacement);

    /** Distance of a point inside from the boundary, m; none outside. */
    std::optional<double>
    depth(const dealii::Point<dim> &point) const;

    /** Do the boxes around the points and around the body meet? */
    bool
    is_near(const std::vector<dealii::Point<dim>> &points) const;

    /** The centres of its cells, m. */
    std::vector<dealii::Point<dim>>
    cell_centres() const;

    /** The longest diagonal of the box of a cell, m. */
    double
    largest_cell() const
    {
      return largest_cell_;
    }

  private:
    NodalMesh<dim>           mesh_;
    NodalInterpolation<dim>  cells_;
    dealii::BoundingBox<dim> box_;
    SurfacePieces<dim>       boundary_;
    double                   largest_cell_;
  };
} // namespace Signorini

#endif
