#include <signorini/geometry/entries.h>
#include <signorini/geometry/fir_tree/fir_tree_cells.h>

#include <deal.II/base/parameter_handler.h>

namespace Signorini
{
  using namespace dealii;

  void
  FirTreeCells::declare_parameters(ParameterHandler &prm)
  {
    prm.declare_entry("Part",
                      "half",
                      Patterns::Selection("half|full"),
                      "`half' is the part with x >= 0, `full' both sides.");
    prm.declare_entry("Contact surface",
                      "flanks",
                      Patterns::Selection("flanks|flanks and fillets"),
                      "What the boundaries contact_1, contact_2, ... consist "
                      "of: the straight working flanks, or these and the two "
                      "arcs next to each, onto which the contact may spread.");
    prm.declare_entry("Flank cells",
                      "8",
                      Patterns::Integer(),
                      "Number of cells along a working flank and along a back "
                      "flank, from 1 to 200. With the same number the meshes "
                      "of blade and disc match on the working flanks.");
    prm.declare_entry("Fillet cells",
                      "8",
                      Patterns::Integer(),
                      "Number of cells along a fillet between two teeth of "
                      "this body, from 1 to 200.");
    prm.declare_entry("Tip cells",
                      "8",
                      Patterns::Integer(),
                      "Number of cells along the tip of a tooth of this body, "
                      "from 1 to 200. With the number that the other body has "
                      "along its fillets the meshes match there, too.");
    prm.declare_entry("Layer cells",
                      "3",
                      Patterns::Integer(),
                      "Number of cells across the layer along the surface, "
                      "from 1 to 200.");
    prm.declare_entry("Core cells",
                      "8",
                      Patterns::Integer(),
                      "Number of cells from this layer to the middle of the "
                      "blade or to the side of the sector, from 1 to 200.");
  }



  void
  FirTreeCells::parse_parameters(const Entries &entries)
  {
    n_flank          = parse_count(entries, "Flank cells");
    n_fillet         = parse_count(entries, "Fillet cells");
    n_tip            = parse_count(entries, "Tip cells");
    n_layer          = parse_count(entries, "Layer cells");
    n_core           = parse_count(entries, "Core cells");
    is_full          = entries.text("Part") == "full";
    contact_has_arcs = entries.text("Contact surface") != "flanks";
  }



  unsigned int
  FirTreeCells::parse_count(const Entries &entries, const std::string &entry)
  {
    const unsigned int n = entries.count(entry, 1);
    if (n > 200)
      entries.refuse(entry, "must be from 1 to 200.");
    return n;
  }
} // namespace Signorini
