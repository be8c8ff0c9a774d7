#ifndef signorini_geometry_fir_tree_blade_root_h
#define signorini_geometry_fir_tree_blade_root_h

#include <signorini/geometry/fir_tree/fir_tree_cells.h>
#include <signorini/geometry/fir_tree/fir_tree_joint.h>
#include <signorini/geometry/mesh_generator.h>

namespace Signorini
{
  /**
   * `blade root` (2-D, subsection `Blade root`): the root of a turbine blade in
   * a fir-tree joint and the beginning of its shank. The origin is the axis of
   * the disc; x = 0 is the middle of the blade.
   *
   * Boundaries: top (the cut through the shank), contact_1 to contact_n (the
   * working flanks, 1 nearest the rim), free (all other surfaces), and of the
   * half symmetry (x = 0). The flanks of the full root have the names
   * contact_1_left, contact_1_right and so on. Region: body.
   *
   * A layer of cells follows the surface; its lines along the fillets are
   * concentric arcs. Inside, each tooth is one block, and blocks lead from the
   * teeth and from the necks to x = 0.
   */
  class BladeRoot : public MeshGenerator<2>
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
    double       shank_height; // m
    unsigned int n_shank;      // cells along the shank
  };
} // namespace Signorini

#endif
