#include <signorini/input/instantiate.h>
#include <signorini/output/displacement_writer.h>
#include <signorini/output/pvd_file.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    std::string
    numbered(const std::string &name,
             const unsigned int number,
             const std::string &ending)
    {
      char text[16];
      std::snprintf(text, sizeof(text), "_%05u", number);
      return name + text + ending;
    }

    const std::string ending      = ".displacement";
    const std::string mesh_ending = "_mesh.displacement";
  } // namespace



  template <int dim>
  DisplacementWriter<dim>::DisplacementWriter(const std::string &folder)
    : folder(folder)
  {}



  template <int dim>
  void
  DisplacementWriter<dim>::write(
    const std::vector<BodyDisplacement<dim>> &bodies,
    const double                              time)
  {
    std::vector<std::string> names;
    for (const BodyDisplacement<dim> &body : bodies)
      names.push_back(body.name);
    names = file_names_of_parts(names);

    std::vector<StoredDisplacement> new_rows;
    for (unsigned int i = 0; i < bodies.size(); ++i)
      {
        const DoFHandler<dim> &dof_handler = *bodies[i].dof_handler;
        MeshFile              &mesh_file   = mesh_files[bodies[i].name];
        std::string            content =
          encode_mesh(nodal_mesh(dof_handler, *bodies[i].mapping));
        if (content != mesh_file.content)
          {
            const std::string name = numbered(names[i], number, mesh_ending);
            write_result_file(path(name), content);
            mesh_file = {name, std::move(content)};
          }
        const std::string file = numbered(names[i], number, ending);
        write_result_file(path(file),
                          encode_displacements(nodal_values(
                            dof_handler, *bodies[i].displacement)));
        new_rows.push_back({time, bodies[i].name, mesh_file.name, file});
      }
    rows.insert(rows.end(), new_rows.begin(), new_rows.end());
    ++number;
    replace_result_file(path(displacement_index), encode_index(rows));
  }



  template <int dim>
  void
  DisplacementWriter<dim>::cut_back() const
  {
    if (rows.empty())
      return;
    replace_result_file(path(displacement_index), encode_index(rows));
    std::vector<std::string> bodies;
    for (const StoredDisplacement &row : rows)
      if (std::find(bodies.begin(), bodies.end(), row.body) == bodies.end())
        bodies.push_back(row.body);
    for (const std::string &name : file_names_of_parts(bodies))
      for (unsigned int beyond = number;; ++beyond)
        {
          std::error_code error;
          std::filesystem::remove(path(numbered(name, beyond, mesh_ending)),
                                  error);
          if (!std::filesystem::remove(path(numbered(name, beyond, ending)),
                                       error))
            break;
        }
  }



  template <int dim>
  std::string
  DisplacementWriter<dim>::path(const std::string &file) const
  {
    return (std::filesystem::path(folder) / file).string();
  }



#define INSTANTIATE(dim) template class DisplacementWriter<dim>;
  SIGNORINI_FOR_EACH_DIMENSION(INSTANTIATE)
#undef INSTANTIATE
} // namespace Signorini
