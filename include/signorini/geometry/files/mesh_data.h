#ifndef signorini_geometry_files_mesh_data_h
#define signorini_geometry_files_mesh_data_h

#include <signorini/geometry/mesh.h>

#include <deal.II/base/point.h>

#include <array>
#include <string>
#include <vector>

namespace Signorini
{
  /** What an element of a mesh file is. */
  enum class ElementKind
  {
    point,
    line,
    triangle,
    quadrilateral,
    tetrahedron,
    pyramid,
    prism,
    hexahedron,
    /** Any element with nodes between its corners. */
    higher_order
  };

  /** Number of corners of an element; 0 for higher_order. */
  unsigned int
  n_corners(const ElementKind kind);

  /** 0 to 3; 0 for higher_order. */
  unsigned int
  dimension(const ElementKind kind);

  /**
   * The content of a mesh file, whatever its format: nodes, elements of all
   * dimensions, and named groups of elements.
   */
  struct MeshData
  {
    struct Element
    {
      ElementKind kind;

      /**
       * Indices into `nodes`, only of the corners. Quadrilaterals go around;
       * hexahedra have their first quadrilateral opposite to the second one.
       */
      std::array<unsigned int, 8> nodes;
    };

    struct Group
    {
      std::string  name;
      unsigned int dimension; // of its elements

      /** Made by the pre-processor on its own, not by the user. */
      bool is_automatic;

      std::vector<unsigned int> elements; // indices into MeshData::elements
    };

    std::string                   file_name;
    std::vector<dealii::Point<3>> nodes;
    std::vector<Element>          elements;
    std::vector<Group>            groups;
  };

  /** `(x y z)` in the units of the file, for messages. */
  std::string
  location_of_node(const MeshData &data, const unsigned int node);

  /**
   * Makes a mesh: elements of dimension `dim` become its cells, groups of them
   * its regions, groups of elements on its surface its boundaries. Coordinates
   * are multiplied by @p scale. Elements of lower dimension inside the body
   * are left out, and so are groups that consist only of such elements. Cells
   * and faces without a group have the id 0.
   *
   * A cell or a face has one id. Groups with the same members share it;
   * otherwise groups of cells that overlap one with fewer members are left out
   * (a group `all` beside its parts), and for groups of faces it is an error.
   * Automatic groups never displace others.
   *
   * @throws InputError with the file name: no cells of this dimension, other
   * kinds of elements, corners outside the x-y plane in 2-D, elements that do
   * not form a mesh, no boundary with a name.
   */
  template <int dim>
  Mesh<dim>
  build_mesh(const MeshData &data, const double scale);
} // namespace Signorini

#endif
