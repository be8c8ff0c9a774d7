#ifndef signorini_geometry_mesh_cutout_h
#define signorini_geometry_mesh_cutout_h

#include <signorini/geometry/mesh.h>
#include <signorini/geometry/neighbourhood.h>

#include <vector>

namespace dealii
{
  class ParameterHandler;
}

namespace Signorini
{
  /**
   * Keeps a region of a mesh, for a submodel:
   *
   * - `Keep cells near = 0, 0.1 : 0.02 ; ...`: point (m), radius (m): all cells
   *   that reach into one of these circles or spheres stay, the others go.
   *   (Cells are represented by the bounding box of their vertices.)
   *
   * Faces that had a neighbour which is gone are the boundary `cut`. All other
   * faces, lines and cells keep the ids and manifolds they had, so that curved
   * boundaries are refined as before. Names of boundaries and regions of which
   * nothing is left are gone.
   */
  template <int dim>
  struct MeshCutout
  {
    /** Empty: the whole mesh. */
    std::vector<Neighbourhood<dim>> near;

    /** Declares the entry in the current section. */
    static void
    declare_parameters(dealii::ParameterHandler &prm);

    /** @throws InputError naming the entry. */
    static MeshCutout
    parse(const dealii::ParameterHandler &prm);

    /**
     * The mesh as a generator made it, without hanging nodes. Afterwards all
     * cells are of level 0.
     * @throws InputError when no cell is left, or when the mesh has a boundary
     * `cut` of its own.
     */
    void
    apply(Mesh<dim> &mesh) const;
  };
} // namespace Signorini

#endif
