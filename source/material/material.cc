#include <signorini/input_error.h>
#include <signorini/material/elastic.h>
#include <signorini/material/material.h>

#include <deal.II/base/parameter_handler.h>

#include <map>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    using Creator = std::unique_ptr<Material> (*)(const ParameterHandler &);

    // The one list of material laws, by their .prm names.
    const std::map<std::string, Creator> &
    laws()
    {
      static const std::map<std::string, Creator> list = {
        {"elastic", &Elastic::create}};
      return list;
    }
  } // namespace



  void
  declare_material_parameters(const std::string &section, ParameterHandler &prm)
  {
    std::string names;
    for (const auto &[name, create] : laws())
      names += (names.empty() ? "" : "|") + name;

    prm.enter_subsection(section);
    prm.declare_entry("Law",
                      "elastic",
                      Patterns::Selection(names),
                      "The constitutive law.");
    prm.declare_entry("Young's modulus",
                      "210e9",
                      Patterns::Double(),
                      "E > 0. Unit: Pa.");
    prm.declare_entry("Poisson's ratio",
                      "0.3",
                      Patterns::Double(),
                      "nu, greater than -1 and less than 0.5. Unit: 1.");
    prm.declare_entry("Density",
                      "7800",
                      Patterns::Double(),
                      "Mass density rho; a dynamic run needs it greater than "
                      "zero. Unit: kg/m^3.");
    prm.leave_subsection();
  }



  std::unique_ptr<Material>
  create_material(const std::string &section, ParameterHandler &prm)
  {
    prm.enter_subsection(section);
    try
      {
        std::unique_ptr<Material> material = laws().at(prm.get("Law"))(prm);
        prm.leave_subsection();
        return material;
      }
    catch (const InputError &error)
      {
        throw InputError(section + " / " + error.what());
      }
  }
} // namespace Signorini
