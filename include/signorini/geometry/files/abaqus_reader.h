#ifndef signorini_geometry_files_abaqus_reader_h
#define signorini_geometry_files_abaqus_reader_h

#include <signorini/geometry/files/mesh_data.h>

#include <string>

namespace Signorini
{
  /**
   * Reads the text of an Abaqus input file: *NODE, *ELEMENT, *ELSET and
   * *SURFACE of one part; everything else is passed over.
   *
   * Groups are the element sets (of cells, or of line and shell elements on
   * the surface) and the surfaces of type ELEMENT, given by faces S1 to S4
   * (quadrilaterals; E1 to E4 too) or S1 to S6 (hexahedra). Sets named in the
   * line *ELEMENT count as automatic.
   * @throws InputError with file and line for what cannot be read.
   */
  MeshData
  read_abaqus(const std::string &file_name, const std::string &text);
} // namespace Signorini

#endif
