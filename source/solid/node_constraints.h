#ifndef signorini_solid_node_constraints_h
#define signorini_solid_node_constraints_h

#include <signorini/solid/dof_map.h>
#include <signorini/solid/supports.h>

#include <deal.II/lac/affine_constraints.h>

#include <vector>

namespace Signorini
{
  /** Adds the constraints of hanging nodes, in the counting of all unknowns. */
  template <int dim>
  void
  add_hanging_nodes(const Body<dim> &body, DofMap &dof_map);

  /**
   * Adds n . u = 0: the component that moves most along the normal follows the
   * others. A hanging node follows nodes of the same plane already.
   * @throws InputError where two such planes meet.
   */
  template <int dim>
  void
  hold_in_plane(const Body<dim>        &body,
                const SlidingNode<dim> &sliding,
                DofMap                 &dof_map);
} // namespace Signorini

#endif
