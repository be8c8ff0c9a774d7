#ifndef signorini_output_surface_table_h
#define signorini_output_surface_table_h

#include <signorini/output/surface_writer.h>

#include <string>

namespace Signorini
{
  /**
   * Writes the nodes of a surface with their scalar fields as a table, one line
   * a node, sorted by x: for plots of pressure along a contact. Values that are
   * not numbers stay empty.
   * @throws ComputationError when the file cannot be written.
   */
  template <int dim>
  void
  write_surface_table(const SurfaceData<dim> &surface, const std::string &path);
} // namespace Signorini

#endif
