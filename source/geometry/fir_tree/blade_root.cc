#include <signorini/geometry/entries.h>
#include <signorini/geometry/fir_tree/blade_root.h>
#include <signorini/geometry/fir_tree/blade_root_patches.h>
#include <signorini/geometry/fir_tree/fir_tree_band.h>

#include <deal.II/base/parameter_handler.h>

namespace Signorini
{
  using namespace dealii;

  void
  BladeRoot::declare_parameters(ParameterHandler &prm)
  {
    prm.enter_subsection("Blade root");
    FirTreeJoint::declare_parameters(prm);
    prm.declare_entry("Shank height",
                      "0.012",
                      Patterns::Double(),
                      "Length of the shank above the top fillet of the root; "
                      "greater than 0. Unit: m.");
    FirTreeCells::declare_parameters(prm);
    prm.declare_entry("Shank cells",
                      "10",
                      Patterns::Integer(),
                      "Number of cells along the shank, from 1 to 200.");
    prm.leave_subsection();
  }



  void
  BladeRoot::parse_parameters(const ParameterHandler &prm)
  {
    const Entries entries(prm, "Blade root");
    joint.parse_parameters(entries);
    cells.parse_parameters(entries);
    shank_height = entries.positive("Shank height");
    n_shank      = FirTreeCells::parse_count(entries, "Shank cells");
  }



  Mesh<2>
  BladeRoot::create() const
  {
    Patchwork patchwork =
      blade_root_patches(joint, cells, shank_height, n_shank);
    if (cells.is_full)
      mirror_fir_tree(patchwork);
    Mesh<2> mesh = patchwork.create();
    name_fir_tree_boundaries(joint, cells.is_full, "top", mesh);
    return mesh;
  }
} // namespace Signorini
