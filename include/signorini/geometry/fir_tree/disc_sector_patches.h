#ifndef signorini_geometry_fir_tree_disc_sector_patches_h
#define signorini_geometry_fir_tree_disc_sector_patches_h

#include <signorini/geometry/fir_tree/fir_tree_cells.h>
#include <signorini/geometry/fir_tree/fir_tree_joint.h>
#include <signorini/geometry/patchwork.h>

namespace Signorini
{
  /**
   * The half x >= 0 of the sector of a disc with a slot for a blade root.
   * @param bore_radius m
   * @param n_bore cells from the bore to the slot
   */
  Patchwork
  disc_sector_patches(const FirTreeJoint &joint,
                      const FirTreeCells &cells,
                      const double        bore_radius,
                      const unsigned int  n_bore);
} // namespace Signorini

#endif
