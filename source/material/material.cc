#include <signorini/material/elastic.h>
#include <signorini/material/elasto_plastic.h>
#include <signorini/material/logarithmic_material.h>
#include <signorini/material/material.h>
#include <signorini/material/neo_hooke.h>
#include <signorini/material/small_strain_material.h>
#include <signorini/material/thermal_expansion.h>

#include <deal.II/base/parameter_handler.h>

#include <cmath>
#include <map>

#include "thickness_search.h"

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    // What a law is made from.
    struct Source
    {
      const ParameterHandler &prm;
      const std::string      &base_directory;
      const Kinematics        kinematics;
      const double            density;
    };

    template <typename Law>
    std::unique_ptr<Material>
    from_strain_law(const Law &law, const Source &source)
    {
      auto copy = std::make_unique<const Law>(law);
      if (source.kinematics == Kinematics::small_strain)
        return std::make_unique<SmallStrainMaterial>(std::move(copy),
                                                     source.density);
      return std::make_unique<LogarithmicMaterial>(std::move(copy),
                                                   source.density);
    }

    std::unique_ptr<Material>
    create_elastic(const Source &source)
    {
      return from_strain_law(Elastic(ElasticConstants::parse(source.prm)),
                             source);
    }

    std::unique_ptr<Material>
    create_elasto_plastic(const Source &source)
    {
      return from_strain_law(ElastoPlastic::parse(source.prm,
                                                  source.base_directory),
                             source);
    }

    std::unique_ptr<Material>
    create_neo_hooke(const Source &source)
    {
      if (source.kinematics == Kinematics::small_strain)
        return create_elastic(source);
      return std::make_unique<NeoHooke>(ElasticConstants::parse(source.prm),
                                        source.density);
    }

    using Creator = std::unique_ptr<Material> (*)(const Source &);

    // The one list of material laws, by their .prm names.
    const std::map<std::string, Creator> &
    laws()
    {
      static const std::map<std::string, Creator> list = {
        {"elastic", &create_elastic},
        {"elasto-plastic", &create_elasto_plastic},
        {"neo-Hooke", &create_neo_hooke}};
      return list;
    }

    double
    parse_density(const ParameterHandler &prm)
    {
      const double density = prm.get_double("Density");
      if (!(density >= 0.))
        throw InputError("Density",
                         "must not be negative, in kg/m^3, found " +
                           prm.get("Density") + ".");
      return density;
    }
  } // namespace



  MaterialResponse
  Material::respond_in_plane_stress(MaterialPoint          &point,
                                    const ArrayView<double> history) const
  {
    const bool      is_finite = kinematics() == Kinematics::finite_strain;
    const double    guess     = point.gradient[2][2];
    ThicknessSearch search(guess);
    while (true)
      {
        // The strain is logarithmic, so that none can invert the thickness.
        const double strain = search.strain();
        point.gradient[2][2] =
          guess + (is_finite ? (1. + guess) * std::expm1(strain) : strain);
        const MaterialResponse response = respond(point, history);
        const double           stress   = response.stress[2][2];
        if (search.is_done(stress,
                           response.stress.norm(),
                           response.tangent[2][2][2][2] +
                             (is_finite ? 2. * stress : 0.)))
          return response;
      }
  }



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
                      "The constitutive law. In small strains, elastic and "
                      "neo-Hooke are both Hooke's law. In finite strains, "
                      "elastic is Hencky's law, Hooke's with logarithmic "
                      "strains and Kirchhoff stress, and neo-Hooke has the "
                      "energy mu/2 (tr C - 3 - 2 ln J) + lambda/2 (ln J)^2. "
                      "elasto-plastic is elastic up to the yield stress of von "
                      "Mises, and reads the entries on hardening below.");
    ElasticConstants::declare_parameters(prm);
    prm.declare_entry("Density",
                      "7800",
                      Patterns::Double(),
                      "Mass density rho before the deformation; a dynamic run "
                      "needs it greater than zero. Unit: kg/m^3.");
    ElastoPlastic::declare_parameters(prm);
    ThermalExpansion::declare_parameters(prm);
    prm.leave_subsection();
  }



  EntryConditions
  material_conditions()
  {
    EntryConditions list = ElastoPlastic::conditions();
    for (const EntryCondition &condition : ThermalExpansion::conditions())
      list.push_back(condition);
    return list;
  }



  std::unique_ptr<Material>
  create_material(const std::string &section,
                  const Kinematics   kinematics,
                  const std::string &base_directory,
                  ParameterHandler  &prm)
  {
    prm.enter_subsection(section);
    try
      {
        const Source              source = {prm,
                                            base_directory,
                                            kinematics,
                                            parse_density(prm)};
        std::unique_ptr<Material> material =
          ThermalExpansion::parse(laws().at(prm.get("Law"))(source), prm);
        prm.leave_subsection();
        return material;
      }
    catch (const InputError &error)
      {
        throw error.in_section(section);
      }
  }
} // namespace Signorini
