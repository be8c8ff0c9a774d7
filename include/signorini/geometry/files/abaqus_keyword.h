#ifndef signorini_geometry_files_abaqus_keyword_h
#define signorini_geometry_files_abaqus_keyword_h

#include <signorini/geometry/files/mesh_data.h>

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace Signorini
{
  /** A line such as `*ELEMENT, TYPE=CPS4, ELSET=beam`. */
  struct AbaqusKeyword
  {
    std::string name; // in upper case, without the star

    /** Names in upper case, values as they are; empty without a value. */
    std::map<std::string, std::string> options;
  };

  AbaqusKeyword
  parse_abaqus_keyword(const std::string &line);

  struct AbaqusElement
  {
    ElementKind  kind;
    unsigned int n_nodes;
  };

  /** The meaning of TYPE=..., or nothing for types that are no solids. */
  std::optional<AbaqusElement>
  abaqus_element(const std::string &type);

  /**
   * The corners of the face S1 (@p face = 0), S2, ... of a quadrilateral or
   * hexahedron; empty if there is no such face.
   */
  std::vector<unsigned int>
  abaqus_face_corners(const ElementKind kind, const unsigned int face);

  std::string
  upper_case(const std::string &text);
} // namespace Signorini

#endif
