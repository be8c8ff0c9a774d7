#ifndef signorini_geometry_gears_tooth_grid_h
#define signorini_geometry_gears_tooth_grid_h

#include <signorini/geometry/cell_patch.h>
#include <signorini/geometry/gears/tooth_row.h>

namespace Signorini
{
  /** The boundary of one tooth and of the rim below it. */
  enum class ToothSide : unsigned int
  {
    tip,
    root,
    rim, // bore or back
    left_flank,
    right_flank,
    left_cut,
    right_cut
  };

  /**
   * Cells of one tooth, in its own frame, of about the size of a flank divided
   * by @p n_cells. Their boundary follows the profile, by equal arc lengths;
   * its lines have a ToothSide as boundary_id.
   *
   * @verbatim
   *         A____A          The tooth above JJ and its foot above KK go across.
   *         /    \          Each root has its own patch from the middle K of
   *       J/______\J        the fillet to the middle R of the space, above the
   *   R__K/________\K__R    layer PQ. Below that is the rim. Three patches meet
   *   |   \        /   |    in K and share the half plane there, so that no
   *  Q|____P______P____|Q   angle is sharp.
   *   |________________|
   * @endverbatim
   *
   * @param rim_height radius of the bore, or y of the back, m
   */
  CellCollection
  tooth_grid(const HalfTooth   &tooth,
             const ToothRow    &row,
             const double       rim_height,
             const unsigned int n_cells);
} // namespace Signorini

#endif
