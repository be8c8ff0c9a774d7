#ifndef signorini_geometry_files_mesh_file_h
#define signorini_geometry_files_mesh_file_h

#include <signorini/geometry/mesh_generator.h>

#include <string>

namespace Signorini
{
  /**
   * `file` (subsection `File`): a mesh from Gmsh (.msh) or Abaqus (.inp). See
   * build_mesh() for what becomes of elements and groups, read_gmsh() and
   * read_abaqus() for what is understood. The mesh knows nothing of curved
   * geometry: refinement keeps the shape of the file's cells.
   */
  template <int dim>
  class MeshFile : public MeshGenerator<dim>
  {
  public:
    /** Relative file names are relative to @p base_directory. */
    explicit MeshFile(std::string base_directory);

    static void
    declare_parameters(dealii::ParameterHandler &prm);

    void
    parse_parameters(const dealii::ParameterHandler &prm) override;

    Mesh<dim>
    create() const override;

  private:
    const std::string base_directory;
    std::string       file_name; // with the folder
    double            scale;     // m per unit of the file
  };
} // namespace Signorini

#endif
