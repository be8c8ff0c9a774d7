#include <signorini/contact/plane.h>
#include <signorini/contact/profile.h>
#include <signorini/contact/rigid_surface.h>
#include <signorini/contact/sphere.h>
#include <signorini/input/instantiate.h>

#include <deal.II/base/parameter_handler.h>

#include <functional>
#include <map>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    template <int dim>
    struct Shape
    {
      std::function<void(ParameterHandler &)> declare;
      std::function<std::unique_ptr<RigidSurface<dim>>(ParameterHandler &,
                                                       const std::string &)>
        create;
    };

    template <int dim>
    Shape<dim>
    round_shape(const std::string &name)
    {
      return {[name](ParameterHandler &prm) {
                Sphere<dim>::declare_parameters(prm, name);
              },
              [name](ParameterHandler &prm, const std::string &section) {
                return Sphere<dim>::create(prm, name, section);
              }};
    }

    // The one list of rigid shapes, by their .prm names.
    template <int dim>
    std::map<std::string, Shape<dim>>
    shapes(const std::string &directory = "")
    {
      std::map<std::string, Shape<dim>> list = {
        {"plane", {&Plane<dim>::declare_parameters, &Plane<dim>::create}}};
      if constexpr (dim == 2)
        {
          list["circle"]  = round_shape<dim>("Circle");
          list["profile"] = {&Profile::declare_parameters,
                             [directory](ParameterHandler  &prm,
                                         const std::string &section) {
                               return Profile::create(prm, section, directory);
                             }};
        }
      else
        {
          list["sphere"]   = round_shape<dim>("Sphere");
          list["cylinder"] = round_shape<dim>("Cylinder");
        }
      return list;
    }
  } // namespace



  template <int dim>
  void
  declare_rigid_surface_parameters(ParameterHandler &prm)
  {
    std::string names;
    for (const auto &[name, shape] : shapes<dim>())
      names += (names.empty() ? "" : "|") + name;
    prm.declare_entry("Shape",
                      "plane",
                      Patterns::Selection(names),
                      "Its shape; the section of this name describes it. A "
                      "plane is a straight line in 2-D; in axisymmetric runs a "
                      "circle on the axis is a sphere.");
    for (const auto &[name, shape] : shapes<dim>())
      shape.declare(prm);
  }



  template <int dim>
  EntryConditions
  rigid_surface_conditions()
  {
    EntryConditions list;
    for (const auto &[name, shape] : shapes<dim>())
      list.push_back(
        contradiction(read_with({section_name(name)}, "Shape", {name})));
    return list;
  }



  template <int dim>
  std::unique_ptr<RigidSurface<dim>>
  create_rigid_surface(ParameterHandler  &prm,
                       const std::string &section,
                       const std::string &directory)
  {
    return shapes<dim>(directory).at(prm.get("Shape")).create(prm, section);
  }



#define INSTANTIATE(dim)                                                   \
  template EntryConditions rigid_surface_conditions<dim>();                \
  template void declare_rigid_surface_parameters<dim>(ParameterHandler &); \
  template std::unique_ptr<RigidSurface<dim>> create_rigid_surface<dim>(   \
    ParameterHandler &, const std::string &, const std::string &);
  SIGNORINI_FOR_EACH_DIMENSION(INSTANTIATE)
#undef INSTANTIATE
} // namespace Signorini
