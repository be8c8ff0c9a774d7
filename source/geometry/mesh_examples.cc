#include <signorini/geometry/mesh_examples.h>
#include <signorini/geometry/mesh_generator.h>
#include <signorini/input/declared_parameters.h>
#include <signorini/input/pattern_in_words.h>

#include <deal.II/base/parameter_handler.h>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    // A few large cells, so that an outline is all there is to see.
    const std::map<std::string, std::string> cells_of_teeth = {
      {"Cells along a flank", "3"}};

    std::map<std::string, std::string>
    entries_of_fir_tree(const std::string &generator, const std::string &part)
    {
      std::map<std::string, std::string> entries = {{"Part", part},
                                                    {"Flank cells", "2"},
                                                    {"Fillet cells", "4"},
                                                    {"Tip cells", "3"},
                                                    {"Layer cells", "1"},
                                                    {"Core cells", "3"}};
      if (generator == "blade root")
        entries["Shank cells"] = "3";
      else
        entries.insert({{"Bore radius", "0.22"}, {"Bore cells", "3"}});
      return entries;
    }

    std::vector<MeshExample>
    examples_of(const std::string &generator, const unsigned int dim)
    {
      const std::string arc = "Angles = 0, 270";
      if (generator == "rectangle" || generator == "box")
        return {{generator, "", {{"Cells", dim == 2 ? "3, 2" : "3, 2, 2"}}}};
      if (generator == "ring")
        return {{generator, arc, {{"Angles", "0, 270"}, {"Cells", "18, 2"}}}};
      if (generator == "tube")
        return {
          {generator, arc, {{"Angles", "0, 270"}, {"Cells", "18, 2, 4"}}}};
      if (generator == "pinion" || generator == "rack")
        return {{generator, "Modelled teeth = 3", cells_of_teeth}};
      if (generator == "blade root" || generator == "disc sector")
        {
          std::vector<MeshExample> examples;
          for (const std::string part : {"half", "full"})
            examples.push_back({generator,
                                "Part = " + part,
                                entries_of_fir_tree(generator, part)});
          return examples;
        }
      if (generator.find("disc") != std::string::npos ||
          generator.find("ball") != std::string::npos)
        return {{generator, "", {{"Initial refinements", "2"}}}};
      return {{generator, "", {}}};
    }
  } // namespace



  template <int dim>
  std::vector<MeshExample>
  mesh_examples()
  {
    ParameterHandler prm;
    declare_mesh_parameters<dim>(prm);
    const DeclaredSection    declared = declared_parameters(prm);
    std::vector<MeshExample> examples;
    for (const std::string &generator :
         names_in_pattern(declared.find_entry("Mesh")->pattern))
      if (generator != "file")
        {
          const std::vector<MeshExample> found = examples_of(generator, dim);
          examples.insert(examples.end(), found.begin(), found.end());
        }
    return examples;
  }



  template <int dim>
  Mesh<dim>
  create_example(const MeshExample &example)
  {
    ParameterHandler prm;
    declare_mesh_parameters<dim>(prm);
    prm.set("Mesh", example.generator);
    prm.enter_subsection(section_name(example.generator));
    for (const auto &[entry, value] : example.entries)
      prm.set(entry, value);
    prm.leave_subsection();
    return create_mesh<dim>(prm, "", "");
  }

  template std::vector<MeshExample>
  mesh_examples<2>();
  template std::vector<MeshExample>
  mesh_examples<3>();
  template Mesh<2>
  create_example<2>(const MeshExample &);
  template Mesh<3>
  create_example<3>(const MeshExample &);
} // namespace Signorini
