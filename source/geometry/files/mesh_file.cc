#include <signorini/geometry/entries.h>
#include <signorini/geometry/files/abaqus_keyword.h>
#include <signorini/geometry/files/abaqus_reader.h>
#include <signorini/geometry/files/gmsh_reader.h>
#include <signorini/geometry/files/mesh_file.h>
#include <signorini/input/input_error.h>
#include <signorini/input/instantiate.h>
#include <signorini/input/nearest_name.h>
#include <signorini/input/regular_file.h>

#include <deal.II/base/parameter_handler.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <utility>

namespace Signorini
{
  using namespace dealii;

  namespace fs = std::filesystem;

  namespace
  {
    // Names of the mesh files in the folder where one was not found.
    std::vector<std::string>
    mesh_files_beside(const fs::path &file)
    {
      std::vector<std::string> names;
      std::error_code          error;
      const fs::path folder = file.has_parent_path() ? file.parent_path() : ".";
      for (const auto &entry : fs::directory_iterator(folder, error))
        if (entry.path().extension() == file.extension())
          names.push_back(entry.path().filename().string());
      return names;
    }

    std::string
    content(const std::string &file_name)
    {
      require_regular_file(file_name, largest_data);
      std::error_code error;
      if (!fs::is_regular_file(file_name, error))
        {
          const fs::path path(file_name);
          throw InputError(
            "there is no file \"" + file_name +
            "\". A relative name begins at the folder of the .prm." +
            did_you_mean(path.filename().string(), mesh_files_beside(path)));
        }
      std::ifstream      in(file_name, std::ios::binary);
      std::ostringstream text;
      text << in.rdbuf();
      if (!in || !text)
        throw InputError("the file \"" + file_name +
                         "\" cannot be read, or is empty.");
      return text.str();
    }
  } // namespace



  template <int dim>
  MeshFile<dim>::MeshFile(std::string base_directory)
    : base_directory(std::move(base_directory))
  {}



  template <int dim>
  void
  MeshFile<dim>::declare_parameters(ParameterHandler &prm)
  {
    prm.enter_subsection("File");
    prm.declare_entry("Name",
                      "",
                      Patterns::Anything(),
                      "Mesh file: Gmsh (.msh, format 2.2 or 4.1, ASCII) or "
                      "Abaqus (.inp). A relative name begins at the folder of "
                      "the .prm. All cells are quadrilaterals or hexahedra; "
                      "boundaries and regions have the names of the file's "
                      "physical groups, sets and surfaces.");
    prm.declare_entry("Scale",
                      "1",
                      Patterns::Double(),
                      "The file's unit of length in m, for example 1e-3 for a "
                      "mesh in mm; greater than 0. Unit: m.");
    prm.leave_subsection();
  }



  template <int dim>
  void
  MeshFile<dim>::parse_parameters(const ParameterHandler &prm)
  {
    const Entries     entries(prm, "File");
    const std::string name = entries.text("Name");
    if (name.empty())
      entries.refuse("Name", "the name of a mesh file is needed.");
    const std::string ending = fs::path(name).extension().string();
    if (upper_case(ending) != ".MSH" && upper_case(ending) != ".INP")
      entries.refuse("Name",
                     "must end with .msh (Gmsh) or .inp (Abaqus). Gmsh "
                     "converts many other formats: gmsh -0 FILE -o mesh.msh");
    file_name = (fs::path(base_directory) / name).string();
    scale     = entries.positive("Scale");
  }



  template <int dim>
  Mesh<dim>
  MeshFile<dim>::create() const
  {
    const bool is_gmsh =
      upper_case(fs::path(file_name).extension().string()) == ".MSH";
    try
      {
        const std::string text = content(file_name);
        return build_mesh<dim>(is_gmsh ? read_gmsh(file_name, text) :
                                         read_abaqus(file_name, text),
                               scale);
      }
    catch (const InputError &error)
      {
        throw InputError("File / Name", error.text());
      }
  }

#define INSTANTIATE(dim) template class MeshFile<dim>;
  SIGNORINI_FOR_EACH_DIMENSION(INSTANTIATE)
#undef INSTANTIATE
} // namespace Signorini
