#ifndef signorini_geometry_refinement_passes_h
#define signorini_geometry_refinement_passes_h

#include <deal.II/grid/tria.h>

#include <vector>

namespace Signorini
{
  /**
   * Refinements one after the other, each as the flags of all active cells in
   * their order, so that a mesh can be made again from its beginning.
   */
  using RefinementPasses = std::vector<std::vector<bool>>;

  /**
   * Refines as the passes say.
   * @throws InputError when a pass does not fit the mesh, when the mesh would
   * get more than 20 million cells, or when a cell would be distorted.
   */
  template <int dim>
  void
  refine_again(const RefinementPasses     &passes,
               dealii::Triangulation<dim> &triangulation);
} // namespace Signorini

#endif
