#ifndef signorini_geometry_fir_tree_blade_root_patches_h
#define signorini_geometry_fir_tree_blade_root_patches_h

#include <signorini/geometry/fir_tree/fir_tree_cells.h>
#include <signorini/geometry/fir_tree/fir_tree_joint.h>
#include <signorini/geometry/patchwork.h>

namespace Signorini
{
  /**
   * The half x >= 0 of a blade root.
   * @param shank_height above the top fillet, m
   * @param n_shank cells along the shank
   */
  Patchwork
  blade_root_patches(const FirTreeJoint &joint,
                     const FirTreeCells &cells,
                     const double        shank_height,
                     const unsigned int  n_shank);
} // namespace Signorini

#endif
