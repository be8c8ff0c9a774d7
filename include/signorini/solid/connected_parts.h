#ifndef signorini_solid_connected_parts_h
#define signorini_solid_connected_parts_h

#include <signorini/solid/body.h>

#include <vector>

namespace Signorini
{
  /**
   * The nodes of a body, part by part: cells that share a node belong to the
   * same part. A mesh may consist of several, and each moves by itself.
   */
  template <int dim>
  std::vector<std::vector<Node<dim>>>
  connected_parts(const Body<dim> &body);
} // namespace Signorini

#endif
