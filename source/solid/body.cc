#include <signorini/geometry/mesh_generator.h>
#include <signorini/input/input_error.h>
#include <signorini/input/instantiate.h>
#include <signorini/input/named_errors.h>
#include <signorini/input/named_list.h>
#include <signorini/input/nearest_name.h>
#include <signorini/solid/body.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/mapping_q.h>
#include <deal.II/fe/mapping_q_cache.h>
#include <deal.II/grid/grid_tools.h>

#include <map>
#include <sstream>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    // From here on elements that take the volume point by point are too stiff:
    // by 0.5 to 1.6 % (degree 1) and 0.2 % (degree 2) in thick cylinders and
    // spheres of 8 and 4 elements, and ever more from there on.
    double
    largest_pointwise_ratio(const unsigned int element_degree)
    {
      return element_degree == 1 ? 0.4 : 0.47;
    }

    // Of small elastic strains.
    double
    poissons_ratio(const Material &material)
    {
      const std::vector<double> history_n(material.n_history_values());
      std::vector<double>       history(history_n);
      const auto                tangent =
        material
          .respond({Tensor<2, 3>(), {}, make_array_view(history_n)},
                   make_array_view(history))
          .tangent;
      // lambda / (2 lambda + 2 G)
      return tangent[0][0][1][1] / (tangent[0][0][0][0] + tangent[0][0][1][1]);
    }

    // Bilinear cells need no table; for curved ones the manifold is asked once
    // a cell instead of at every visit.
    template <int dim>
    std::unique_ptr<Mapping<dim>>
    create_mapping(const unsigned int        degree,
                   const Triangulation<dim> &triangulation)
    {
      if (degree == 1)
        return std::make_unique<MappingQ<dim>>(1);
      auto mapping = std::make_unique<MappingQCache<dim>>(degree);
      mapping->initialize(MappingQ<dim>(degree), triangulation);
      return mapping;
    }
  } // namespace



  template <int dim>
  void
  Body<dim>::declare_parameters(const std::vector<std::string> &regions,
                                ParameterHandler               &prm)
  {
    declare_mesh_parameters<dim>(prm);
    prm.declare_entry("Element degree",
                      "1",
                      Patterns::Integer(1, 6),
                      "Polynomial degree of the displacements (FE_Q). 1: "
                      "bilinear, 2: biquadratic with curved edges.");
    prm.declare_entry("Dilatation",
                      "automatic",
                      Patterns::Selection("automatic|pointwise|mean"),
                      "The change of volume in a cell. pointwise: as the "
                      "displacements say; mean: its mean, so that elements do "
                      "not lock where the volume can hardly change: with "
                      "Element degree 1 the same at all points of a cell "
                      "(Q1-P0), with degree k polynomials of degree k - 1; "
                      "automatic: mean for elasto-plastic bodies, and where "
                      "Poisson's ratio is over 0.4 (Element degree 1) or 0.47 "
                      "(higher degrees).");
    prm.declare_entry("Thickness",
                      "1",
                      Patterns::Double(0.),
                      "Thickness of a plane body; loads and contact forces "
                      "are totals over it. Unit: m.");
    prm.declare_entry(
      "Temperature",
      "",
      Patterns::Anything(),
      "Function of the place before the deformation and of "
      "time, read by materials with Thermal expansion. Empty: "
      "the Reference temperature. Unit: that of the reference.");
    prm.declare_entry("Mass damping",
                      "0",
                      Patterns::Double(0.),
                      "a in Rayleigh's C = a M + b K. Unit: 1/s.");
    prm.declare_entry("Stiffness damping",
                      "0",
                      Patterns::Double(0.),
                      "b in Rayleigh's C = a M + b K. Unit: s.");
    prm.declare_entry("Regions",
                      "",
                      Patterns::Anything(),
                      "Names of regions of the mesh that have a material of "
                      "their own, separated by commas. Each has a section "
                      "`Material NAME'; the rest of the body has the section "
                      "`Material'.");
    declare_material_parameters("Material", prm);
    for (const auto &region : regions)
      declare_material_parameters("Material " + region, prm);
  }



  template <int dim>
  EntryConditions
  Body<dim>::conditions()
  {
    EntryConditions list = mesh_conditions<dim>();
    list.push_back(read_with({"Thickness"},
                             "Formulation",
                             {"plane strain", "plane stress"}));
    list.push_back(read_with({"Mass damping", "Stiffness damping"},
                             "Time/Analysis",
                             {"dynamic"}));
    return list;
  }



  template <int dim>
  Body<dim>::Body(const std::string      &name,
                  const Formulation       formulation,
                  const Kinematics        kinematics,
                  const std::string      &base_directory,
                  const unsigned int      first_dof,
                  const RefinementPasses &passes,
                  ParameterHandler       &prm)
    : name_(name)
    , formulation_(formulation)
    , kinematics_(kinematics)
    , has_mean_dilatation_(false)
    , mesh_(
        with_section("Body " + name,
                     [&] {
                       return create_mesh<dim>(prm,
                                               base_directory,
                                               formulation ==
                                                   Formulation::axisymmetric ?
                                                 "axisymmetric" :
                                                 "");
                     }))
    , material_(with_section("Body " + name,
                             [&] {
                               return create_material("Material",
                                                      kinematics_,
                                                      base_directory,
                                                      prm);
                             }))
    , thickness_(prm.get_double("Thickness"))
    , mass_damping_(prm.get_double("Mass damping"))
    , stiffness_damping_(prm.get_double("Stiffness damping"))
    , first_dof_(first_dof)
  {
    if (thickness_ <= 0.)
      throw InputError("Body " + name + " / Thickness",
                       "must be greater than zero, in m, found " +
                         prm.get("Thickness") + ".");
    refine_again(passes, *mesh_.triangulation);
    create_region_materials(base_directory, prm);
    choose_dilatation(prm);
    distribute_dofs(prm.get_integer("Element degree"));
  }



  template <int dim>
  void
  Body<dim>::read_temperature(const Constants        &constants,
                              const ParameterHandler &prm)
  {
    const std::string entry     = "Body " + name_ + " / Temperature";
    const std::string text      = prm.get("Temperature");
    const auto        materials = this->materials();
    if (text.empty())
      return;
    if (std::none_of(materials.begin(),
                     materials.end(),
                     [](const Material *material) {
                       return material->expands();
                     }))
      throw InputError(entry,
                       "has no effect, since no material of the body has a "
                       "Thermal expansion. Give one, or leave the entry out.");
    temperature_.emplace(text, 1, constants, entry, Dependence::space_and_time);
  }



  template <int dim>
  void
  Body<dim>::create_region_materials(const std::string &base_directory,
                                     ParameterHandler  &prm)
  {
    for (const std::string &region : split_list(prm.get("Regions"), ','))
      {
        const auto found = mesh_.regions.find(region);
        if (found == mesh_.regions.end())
          {
            std::vector<std::string> names;
            for (const auto &[known, id] : mesh_.regions)
              names.push_back(known);
            throw InputError("Body " + name_ + " / Regions",
                             "the mesh has no region \"" + region + "\"." +
                               did_you_mean(region, names) +
                               " It has: " + comma_separated(names) + ".");
          }
        region_materials_[found->second] = with_section("Body " + name_, [&] {
          return create_material("Material " + region,
                                 kinematics_,
                                 base_directory,
                                 prm);
        });
      }
  }



  template <int dim>
  void
  Body<dim>::choose_dilatation(const ParameterHandler &prm)
  {
    const std::string choice = prm.get("Dilatation");
    if (formulation_ == Formulation::plane_stress)
      {
        if (choice == "mean")
          throw InputError(
            "Body " + name_ + " / Dilatation",
            "mean has no sense in plane stress, where the thickness follows "
            "and nothing locks. Set Dilatation = automatic.");
        return;
      }
    has_mean_dilatation_ = choice == "mean";
    if (choice != "automatic")
      return;
    const double largest =
      largest_pointwise_ratio(prm.get_integer("Element degree"));
    for (const Material *const material : materials())
      if (material->flows() || poissons_ratio(*material) > largest)
        has_mean_dilatation_ = true;
  }



  template <int dim>
  std::vector<const Material *>
  Body<dim>::materials() const
  {
    std::vector<const Material *> list = {material_.get()};
    for (const auto &[id, material] : region_materials_)
      list.push_back(material.get());
    return list;
  }



  template <int dim>
  void
  Body<dim>::distribute_dofs(const unsigned int degree)
  {
    scalar_fe_   = std::make_unique<FE_Q<dim>>(degree);
    fe_          = std::make_unique<FESystem<dim>>(*scalar_fe_, dim);
    mapping_     = create_mapping(degree, *mesh_.triangulation);
    dof_handler_ = std::make_unique<DoFHandler<dim>>(*mesh_.triangulation);
    dof_handler_->distribute_dofs(*fe_);

    // Gather the components of each node: cell by cell the element says which
    // of its unknowns stand at the same support point.
    std::map<types::global_dof_index, unsigned int> node_of_first_dof;
    std::vector<Point<dim>>                         points(n_dofs());
    DoFTools::map_dofs_to_support_points(*mapping_, *dof_handler_, points);
    std::vector<types::global_dof_index> indices(fe_->n_dofs_per_cell());
    for (const auto &cell : dof_handler_->active_cell_iterators())
      {
        cell->get_dof_indices(indices);
        for (unsigned int a = 0; a < scalar_fe_->n_dofs_per_cell(); ++a)
          {
            const auto first = indices[fe_->component_to_system_index(0, a)];
            if (!node_of_first_dof.emplace(first, nodes_.size()).second)
              continue;
            Node<dim> node;
            node.point = points[first];
            for (unsigned int c = 0; c < dim; ++c)
              node.dofs[c] =
                first_dof_ + indices[fe_->component_to_system_index(c, a)];
            nodes_.push_back(node);
          }
      }
  }



  template <int dim>
  std::vector<Node<dim>>
  Body<dim>::boundary_nodes(const std::string &boundary) const
  {
    const IndexSet on_boundary =
      DoFTools::extract_boundary_dofs(*dof_handler_,
                                      ComponentMask(),
                                      {mesh_.boundary(boundary)});
    std::vector<Node<dim>> result;
    for (const auto &node : nodes_)
      if (on_boundary.is_element(node.dofs[0] - first_dof_))
        result.push_back(node);
    return result;
  }



  template <int dim>
  const Node<dim> &
  Body<dim>::node_near(const Point<dim> &point, const std::string &entry) const
  {
    const auto nearest = std::min_element(
      nodes_.begin(), nodes_.end(), [&](const auto &a, const auto &b) {
        return a.point.distance_square(point) < b.point.distance_square(point);
      });
    const double reach =
      GridTools::minimal_cell_diameter(*mesh_.triangulation, *mapping_);
    if (nearest->point.distance(point) > reach)
      {
        std::ostringstream message;
        message << "the point (" << point << ") lies outside of body \""
                << name_ << "\"; its nearest node is at (" << nearest->point
                << "). Give a point on the body.";
        throw InputError(entry, message.str());
      }
    return *nearest;
  }



  template <int dim>
  DofVector
  Body<dim>::extract(const DofVector &global) const
  {
    return DofVector(global.begin() + first_dof_,
                     global.begin() + first_dof_ + n_dofs());
  }



#define INSTANTIATE(dim) template class Body<dim>;
  SIGNORINI_FOR_EACH_DIMENSION(INSTANTIATE)
#undef INSTANTIATE
} // namespace Signorini
