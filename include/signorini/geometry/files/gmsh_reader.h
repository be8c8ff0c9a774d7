#ifndef signorini_geometry_files_gmsh_reader_h
#define signorini_geometry_files_gmsh_reader_h

#include <signorini/geometry/files/mesh_data.h>

#include <string>

namespace Signorini
{
  /**
   * Reads the text of a Gmsh file in the formats 2.0 to 2.2 or 4.1. Physical
   * groups become groups; those without a name get their number as name.
   * @throws InputError with file and line for anything that does not belong
   * there, and for a file that is cut off.
   */
  MeshData
  read_gmsh(const std::string &file_name, const std::string &text);
} // namespace Signorini

#endif
