#ifndef signorini_geometry_mesh_sketch_h
#define signorini_geometry_mesh_sketch_h

#include <signorini/geometry/mesh.h>

#include <string>

namespace Signorini
{
  /**
   * The mesh as a picture (SVG): its boundaries, each in a colour and with its
   * name, and the axes. In 3-D it is a parallel projection, seen from the side
   * where x, y and z are large; boundaries that are all behind the body get
   * their name beside it.
   *
   * Coordinates are rounded to a tenth of a pixel, so that the text does not
   * depend on the last digits of the mesh.
   */
  template <int dim>
  std::string
  mesh_sketch(const Mesh<dim> &mesh);
} // namespace Signorini

#endif
