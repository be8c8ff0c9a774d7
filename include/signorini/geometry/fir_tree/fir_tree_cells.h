#ifndef signorini_geometry_fir_tree_fir_tree_cells_h
#define signorini_geometry_fir_tree_fir_tree_cells_h

#include <string>

namespace dealii
{
  class ParameterHandler;
}

namespace Signorini
{
  class Entries;

  /** How one body of a fir-tree joint is meshed. */
  struct FirTreeCells
  {
    unsigned int n_flank;  // along a working flank, and along a back flank
    unsigned int n_fillet; // along a fillet between two teeth of the body
    unsigned int n_tip;    // along the tip of a tooth of the body
    unsigned int n_layer;  // across the layer along the surface
    unsigned int n_core;   // from this layer to the middle
    bool         is_full;  // both sides, not only x >= 0
    bool         contact_has_arcs;

    static void
    declare_parameters(dealii::ParameterHandler &prm);

    /** @throws InputError */
    void
    parse_parameters(const Entries &entries);

    /**
     * A number of cells along something, from 1 to 200.
     * @throws InputError
     */
    static unsigned int
    parse_count(const Entries &entries, const std::string &entry);
  };
} // namespace Signorini

#endif
