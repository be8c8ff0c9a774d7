#include <signorini/geometry/mesh_examples.h>
#include <signorini/geometry/mesh_sketch.h>
#include <signorini/input/input_error.h>
#include <signorini/input/parameter_json.h>
#include <signorini/output/whole_file.h>
#include <signorini/run/problem.h>
#include <signorini/run/reference.h>
#include <signorini/run/reference_text.h>

#include <algorithm>
#include <filesystem>
#include <sstream>
#include <system_error>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    // A problem with one section of each kind.
    template <int dim>
    ProblemOutline
    reference_outline()
    {
      return {formulation_from_name(dim == 2 ? "plane strain" :
                                               "three dimensional"),
              {"NAME"},
              {"NAME"},
              {{"NAME"}},
              {"PAIR"}};
    }

    template <int dim>
    std::string
    suffix()
    {
      return dim == 2 ? "_2d" : "_3d";
    }

    // Writes the entries for programs and returns them.
    template <int dim>
    DeclaredProblem
    declared_problem(const std::string &folder)
    {
      const ProblemOutline outline = reference_outline<dim>();
      ParameterHandler     prm;
      declare_problem_parameters<dim>(outline, prm);
      if (dim == 3)
        prm.set("Formulation", std::string("three dimensional"));
      std::ostringstream xml;
      prm.print_parameters(xml,
                           ParameterHandler::XML |
                             ParameterHandler::KeepDeclarationOrder);
      const std::string     base    = folder + "/parameters" + suffix<dim>();
      const DeclaredSection section = declared_parameters(prm);
      write_to_disk(base + ".xml", xml.str());
      write_to_disk(base + ".json", parameter_json(section));
      return {section, problem_conditions<dim>(outline)};
    }

    // "sketches/half_ball_2d.svg"; a second one of a generator has a number.
    std::string
    file_of_sketch(std::string        generator,
                   const std::string &dimension,
                   const std::size_t  n_others)
    {
      std::replace(generator.begin(), generator.end(), ' ', '_');
      return "sketches/" + generator + dimension +
             (n_others == 0 ? "" : "_" + std::to_string(n_others + 1)) + ".svg";
    }

    template <int dim>
    void
    write_sketches(const std::string &folder, BoundarySketches &sketches)
    {
      std::map<std::string, std::size_t> n_sketches;
      for (const MeshExample &example : mesh_examples<dim>())
        {
          const Mesh<dim> mesh = create_example<dim>(example);
          BoundarySketch  sketch;
          sketch.file = file_of_sketch(example.generator,
                                       suffix<dim>(),
                                       n_sketches[example.generator]++);
          sketch.caption =
            std::to_string(dim) + "-D" +
            (example.variant.empty() ? "" : " with " + example.variant);
          for (const auto &boundary : mesh.boundaries)
            sketch.boundaries.push_back(boundary.first);
          write_to_disk(folder + "/" + sketch.file, mesh_sketch(mesh));
          sketches[section_name(example.generator)].push_back(sketch);
        }
    }

    void
    write_all(const std::string &folder)
    {
      std::filesystem::create_directories(folder + "/sketches");
      BoundarySketches sketches;
      write_sketches<2>(folder, sketches);
      write_sketches<3>(folder, sketches);
      const DeclaredProblem plane    = declared_problem<2>(folder);
      const DeclaredProblem spatial  = declared_problem<3>(folder);
      const auto            sections = parameter_reference(plane, spatial);
      write_to_disk(folder + "/reference.md",
                    reference_text(sections, sketches, *markdown()));
      write_to_disk(folder + "/reference.html",
                    reference_text(sections, sketches, *html()));
    }
  } // namespace



  void
  write_reference(const std::string &folder)
  {
    try
      {
        write_all(folder);
      }
    catch (const std::system_error &error)
      {
        throw InputError("--write-reference: the folder \"" + folder +
                         "\" cannot be written to: " + error.code().message() +
                         ". Name another one, or make room.");
      }
  }
} // namespace Signorini
