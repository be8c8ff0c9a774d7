#ifndef signorini_geometry_cell_patch_h
#define signorini_geometry_cell_patch_h

#include <signorini/geometry/polyline.h>

#include <deal.II/grid/tria_description.h>

#include <functional>
#include <vector>

namespace Signorini
{
  /** What a triangulation is made of. Vertices may be repeated. */
  struct CellCollection
  {
    std::vector<dealii::Point<2>>    vertices;
    std::vector<dealii::CellData<2>> cells;
    std::vector<dealii::CellData<1>> lines; // of the boundary
  };

  /**
   * The sides of a patch of quadrilaterals: bottom and top go to the right,
   * left and right go up, and opposite sides have as many points.
   */
  struct CellPatch
  {
    std::vector<dealii::Point<2>> bottom;
    std::vector<dealii::Point<2>> top;
    std::vector<dealii::Point<2>> left;
    std::vector<dealii::Point<2>> right;
  };

  /** The ends of @p n cells along a curve over [0, 1]. */
  std::vector<dealii::Point<2>>
  divide(const unsigned int                             n,
         const std::function<dealii::Point<2>(double)> &curve);

  std::vector<dealii::Point<2>>
  divide_line(const unsigned int      n,
              const dealii::Point<2> &begin,
              const dealii::Point<2> &end);

  CellPatch
  mirrored(const CellPatch &patch);

  /**
   * Adds the cells of a patch. Inner vertices follow from those of the sides
   * b, t, l, r by transfinite interpolation (Gordon and Hall): with the
   * fractions x and y of the numbers of cells,
   *
   *   (1-y) b(x) + y t(x) + (1-x) l(y) + x r(y)
   *     - (1-x)(1-y) b(0) - x (1-y) b(1) - (1-x) y t(0) - x y t(1).
   */
  void
  add_patch(const CellPatch &patch, CellCollection &collection);

  /** Adds lines between the points, with this boundary id. */
  void
  add_lines(const std::vector<dealii::Point<2>> &points,
            const dealii::types::boundary_id     id,
            CellCollection                      &collection);
} // namespace Signorini

#endif
