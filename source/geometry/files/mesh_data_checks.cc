#include <signorini/geometry/files/mesh_data_checks.h>
#include <signorini/input/input_error.h>

#include <algorithm>
#include <cmath>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    [[noreturn]] void
    refuse_simplices(const MeshData &data, const unsigned int dim)
    {
      throw InputError(
        data.file_name + ": has " +
        (dim == 2 ? "triangles" : "tetrahedra, pyramids or prisms") +
        ", but all cells must be " +
        (dim == 2 ? "quadrilaterals" : "hexahedra") +
        ". In Gmsh put these lines into the .geo file and mesh again: "
        "Mesh.Algorithm=6; Mesh.RecombineAll=1; Mesh.SubdivisionAlgorithm=" +
        (dim == 2 ? "1;" : "2; (or use Transfinite and Extrude)"));
    }

    [[noreturn]] void
    refuse_dimension(const MeshData    &data,
                     const unsigned int found,
                     const unsigned int dim)
    {
      throw InputError(
        data.file_name + ": is a " + std::to_string(found) +
        "-D mesh, but the Formulation needs a " + std::to_string(dim) +
        "-D one. Choose another Formulation, or save the mesh of dimension " +
        std::to_string(dim) + " (in Gmsh: gmsh -" + std::to_string(dim) +
        ", with a Physical " + (dim == 2 ? "Surface" : "Volume") +
        " for the body).");
    }
  } // namespace



  void
  check_kinds(const MeshData &data, const unsigned int dim)
  {
    if (data.elements.empty())
      throw InputError(data.file_name + ": has no elements. Was the mesh "
                                        "made before the file was saved?");

    unsigned int largest_dimension = 0;
    bool         simplices         = false;
    for (const MeshData::Element &element : data.elements)
      {
        if (element.kind == ElementKind::higher_order)
          throw InputError(data.file_name +
                           ": has elements with nodes between their corners, "
                           "but only linear ones can be used. In Gmsh set "
                           "Mesh.ElementOrder=1 and mesh again.");
        largest_dimension =
          std::max(largest_dimension, dimension(element.kind));
        simplices = simplices || (dimension(element.kind) == dim &&
                                  element.kind != ElementKind::quadrilateral &&
                                  element.kind != ElementKind::hexahedron);
      }
    if (largest_dimension != dim)
      refuse_dimension(data, largest_dimension, dim);
    if (simplices)
      refuse_simplices(data, dim);
  }



  void
  check_plane(const MeshData &data)
  {
    double size = 0.;
    for (const Point<3> &node : data.nodes)
      size = std::max({size, std::abs(node[0]), std::abs(node[1])});
    for (const MeshData::Element &element : data.elements)
      if (element.kind == ElementKind::quadrilateral)
        for (unsigned int v = 0; v < 4; ++v)
          if (std::abs(data.nodes[element.nodes[v]][2]) > 1e-10 * size)
            throw InputError(data.file_name +
                             ": a plane mesh must lie in the plane z = 0, but "
                             "has a corner at " +
                             location_of_node(data, element.nodes[v]) +
                             ". Draw it in the x-y plane.");
  }



  void
  check_named_boundaries(const GroupIds    &boundary_ids,
                         const MeshData    &data,
                         const unsigned int dim)
  {
    if (boundary_ids.id_of_name.empty())
      throw InputError(
        data.file_name +
        ": no part of the boundary has a name, so that nothing could be "
        "supported, loaded or brought into contact. In Gmsh name them by " +
        (dim == 2 ? "Physical Curve(\"bottom\") = {1};" :
                    "Physical Surface(\"bottom\") = {1};") +
        " in an Abaqus file by *SURFACE, NAME=bottom.");
  }
} // namespace Signorini
