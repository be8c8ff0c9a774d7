#ifndef signorini_geometry_mesh_refinement_h
#define signorini_geometry_mesh_refinement_h

#include <signorini/geometry/mesh.h>

#include <deal.II/base/point.h>

#include <string>
#include <vector>

namespace dealii
{
  class ParameterHandler;
}

namespace Signorini
{
  /**
   * The refinements that every mesh can get, in this order:
   *
   * - `Global refinements = n`: all cells, n times.
   * - `Refinements towards = rim : 3 ; bottom : 2 : 0.001`: n times all cells
   *   with a face on the boundary; with a distance (m), n times all cells with
   *   a vertex not farther than that from the boundary.
   * - `Refinements near = 0, 0.1 : 0.02 : 3 ; ...`: point (m), radius (m), n: n
   *   times all cells that reach into this circle or sphere. (Cells are
   *   represented by their bounding box.)
   *
   * Refining a cell cuts it in half in each direction. Neighbours differ by at
   * most one level, so that some more cells are refined along the border; the
   * hanging nodes in between need constraints.
   */
  template <int dim>
  struct MeshRefinement
  {
    struct Towards
    {
      std::string  boundary;
      unsigned int n_times;
      double       distance; // m, negative: cells with a face on the boundary
    };

    struct Near
    {
      dealii::Point<dim> center; // m
      double             radius; // m
      unsigned int       n_times;
    };

    unsigned int         n_global = 0;
    std::vector<Towards> towards;
    std::vector<Near>    near;

    /** Declares the three entries in the current section. */
    static void
    declare_parameters(dealii::ParameterHandler &prm);

    /** @throws InputError naming the entry. */
    static MeshRefinement
    parse(const dealii::ParameterHandler &prm);

    /**
     * @throws InputError when there is no such boundary, when the mesh would
     * get more than 20 million cells, or when a cell would be distorted.
     */
    void
    apply(Mesh<dim> &mesh) const;
  };

  /** Refines all cells @p n_times. @throws InputError as apply(). */
  template <int dim>
  void
  refine_globally(dealii::Triangulation<dim> &triangulation,
                  const unsigned int          n_times);
} // namespace Signorini

#endif
