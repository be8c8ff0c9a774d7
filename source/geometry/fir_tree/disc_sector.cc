#include <signorini/geometry/entries.h>
#include <signorini/geometry/fir_tree/disc_sector.h>
#include <signorini/geometry/fir_tree/disc_sector_patches.h>
#include <signorini/geometry/fir_tree/fir_tree_band.h>
#include <signorini/geometry/fir_tree/fir_tree_profile.h>

#include <deal.II/base/parameter_handler.h>

namespace Signorini
{
  using namespace dealii;

  void
  DiscSector::declare_parameters(ParameterHandler &prm)
  {
    prm.enter_subsection("Disc sector");
    FirTreeJoint::declare_parameters(prm);
    prm.declare_entry("Bore radius",
                      "0.2",
                      Patterns::Double(),
                      "Inner radius of the disc; greater than 0, and less than "
                      "the distance of the slot's bottom from the axis by at "
                      "least the root radius. Unit: m.");
    FirTreeCells::declare_parameters(prm);
    prm.declare_entry("Bore cells",
                      "12",
                      Patterns::Integer(),
                      "Number of cells from the bore to the layer around the "
                      "slot, from 1 to 200.");
    prm.leave_subsection();
  }



  void
  DiscSector::parse_parameters(const ParameterHandler &prm)
  {
    const Entries entries(prm, "Disc sector");
    joint.parse_parameters(entries);
    cells.parse_parameters(entries);
    bore_radius = entries.positive("Bore radius");
    n_bore      = FirTreeCells::parse_count(entries, "Bore cells");

    const double largest =
      slot_profile(joint).back().end[1] - joint.root_radius;
    if (!(bore_radius <= largest))
      entries.refuse("Bore radius",
                     "must not be greater than " + limit_in_words(largest) +
                       ", the bottom of the slot less the root radius.");
  }



  Mesh<2>
  DiscSector::create() const
  {
    Patchwork patchwork =
      disc_sector_patches(joint, cells, bore_radius, n_bore);
    if (cells.is_full)
      mirror_fir_tree(patchwork);
    Mesh<2> mesh = patchwork.create();
    name_fir_tree_boundaries(joint, cells.is_full, "bore", mesh);
    mesh.boundaries[cells.is_full ? "side_right" : "side"] =
      FirTreeBoundary::side;
    if (cells.is_full)
      mesh.boundaries["side_left"] = FirTreeBoundary::side_left;
    return mesh;
  }
} // namespace Signorini
