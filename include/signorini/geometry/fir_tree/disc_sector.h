#ifndef signorini_geometry_fir_tree_disc_sector_h
#define signorini_geometry_fir_tree_disc_sector_h

#include <signorini/geometry/fir_tree/fir_tree_cells.h>
#include <signorini/geometry/fir_tree/fir_tree_joint.h>
#include <signorini/geometry/mesh_generator.h>

namespace Signorini
{
  /**
   * `disc sector` (2-D, subsection `Disc sector`): one blade's share of a
   * turbine disc, from the bore to the rim, with the slot of a fir-tree joint
   * in the middle, x = 0. The origin is the axis of the disc; the sides are
   * radial, at 180 degrees divided by the number of blades from the y axis.
   *
   * Boundaries: bore, side, contact_1 to contact_n (the working flanks, 1
   * nearest the rim), free (the rim and all other surfaces of the slot), and of
   * the half symmetry (x = 0). In the full sector side and flanks have the
   * names side_left, side_right, contact_1_left and so on. Region: body.
   *
   * A disc that turns moves like its neighbours: its sides keep their plane.
   */
  class DiscSector : public MeshGenerator<2>
  {
  public:
    static void
    declare_parameters(dealii::ParameterHandler &prm);

    void
    parse_parameters(const dealii::ParameterHandler &prm) override;

    Mesh<2>
    create() const override;

  private:
    FirTreeJoint joint;
    FirTreeCells cells;
    double       bore_radius; // m
    unsigned int n_bore;      // cells from the bore to the slot
  };
} // namespace Signorini

#endif
