#include <signorini/geometry/files/mesh_file.h>
#include <signorini/geometry/fir_tree/blade_root.h>
#include <signorini/geometry/fir_tree/disc_sector.h>
#include <signorini/geometry/gears/pinion.h>
#include <signorini/geometry/gears/rack.h>
#include <signorini/geometry/mesh_cutout.h>
#include <signorini/geometry/mesh_generator.h>
#include <signorini/geometry/mesh_refinement.h>
#include <signorini/geometry/shapes/ball.h>
#include <signorini/geometry/shapes/block.h>
#include <signorini/geometry/shapes/half_ball.h>
#include <signorini/geometry/shapes/quarter_disc.h>
#include <signorini/geometry/shapes/ring.h>
#include <signorini/geometry/shapes/tube.h>
#include <signorini/input/input_error.h>
#include <signorini/input/instantiate.h>

#include <deal.II/base/parameter_handler.h>

#include <algorithm>
#include <sstream>
#include <vector>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    template <int dim>
    struct Generator
    {
      std::string name;
      void (*declare_parameters)(ParameterHandler &);
      std::unique_ptr<MeshGenerator<dim>> (*make)(const std::string &);
    };

    template <int dim, typename Type>
    std::unique_ptr<MeshGenerator<dim>>
    make(const std::string & /*base_directory*/)
    {
      return std::make_unique<Type>();
    }

    template <int dim>
    std::unique_ptr<MeshGenerator<dim>>
    make_file(const std::string &base_directory)
    {
      return std::make_unique<MeshFile<dim>>(base_directory);
    }

    // The one list of mesh generators, by their .prm names.
    template <int dim>
    const std::vector<Generator<dim>> &
    generators();

    template <>
    const std::vector<Generator<2>> &
    generators<2>()
    {
      static const std::vector<Generator<2>> list = {
        {"rectangle", &Block<2>::declare_parameters, &make<2, Block<2>>},
        {"disc", &Ball<2>::declare_parameters, &make<2, Ball<2>>},
        {"half disc", &HalfBall<2>::declare_parameters, &make<2, HalfBall<2>>},
        {"half ball", &QuarterDisc::declare_parameters, &make<2, QuarterDisc>},
        {"ring", &Ring::declare_parameters, &make<2, Ring>},
        {"blade root", &BladeRoot::declare_parameters, &make<2, BladeRoot>},
        {"disc sector", &DiscSector::declare_parameters, &make<2, DiscSector>},
        {"pinion", &Pinion::declare_parameters, &make<2, Pinion>},
        {"rack", &Rack::declare_parameters, &make<2, Rack>},
        {"file", &MeshFile<2>::declare_parameters, &make_file<2>}};
      return list;
    }

    template <>
    const std::vector<Generator<3>> &
    generators<3>()
    {
      static const std::vector<Generator<3>> list = {
        {"box", &Block<3>::declare_parameters, &make<3, Block<3>>},
        {"ball", &Ball<3>::declare_parameters, &make<3, Ball<3>>},
        {"half ball", &HalfBall<3>::declare_parameters, &make<3, HalfBall<3>>},
        {"tube", &Tube::declare_parameters, &make<3, Tube>},
        {"file", &MeshFile<3>::declare_parameters, &make_file<3>}};
      return list;
    }
  } // namespace



  template <int dim>
  void
  declare_mesh_parameters(ParameterHandler &prm)
  {
    std::string names;
    for (const Generator<dim> &generator : generators<dim>())
      names += (names.empty() ? "" : "|") + generator.name;

    prm.declare_entry("Mesh",
                      generators<dim>().front().name,
                      Patterns::Selection(names),
                      "The shape of the body, described in the subsection of "
                      "the same name; `file' reads a mesh.");
    for (const Generator<dim> &generator : generators<dim>())
      generator.declare_parameters(prm);
    MeshCutout<dim>::declare_parameters(prm);
    MeshRefinement<dim>::declare_parameters(prm);
  }



  template <int dim>
  EntryConditions
  mesh_conditions()
  {
    EntryConditions list;
    for (const Generator<dim> &generator : generators<dim>())
      list.push_back(contradiction(
        read_with({section_name(generator.name)}, "Mesh", {generator.name})));
    return list;
  }



  template <int dim>
  Mesh<dim>
  create_mesh(const ParameterHandler &prm,
              const std::string      &base_directory,
              const std::string      &formulation)
  {
    const std::string name = prm.get("Mesh");
    const auto        found =
      std::find_if(generators<dim>().begin(),
                   generators<dim>().end(),
                   [&](const auto &entry) { return entry.name == name; });
    Assert(found != generators<dim>().end(), ExcInternalError());

    const std::unique_ptr<MeshGenerator<dim>> generator =
      found->make(base_directory);
    generator->parse_parameters(prm);
    const auto cutout     = MeshCutout<dim>::parse(prm);
    const auto refinement = MeshRefinement<dim>::parse(prm);

    Mesh<dim> mesh;
    try
      {
        mesh = generator->create();
        cutout.apply(mesh);
        refinement.apply(mesh);
      }
    catch (const ExceptionBase &)
      {
        // Of the library: cells without a size, or without digits left for it.
        throw InputError(
          "Mesh",
          "no " + name +
            " can be made of these measures. They are too large, "
            "too small, or too different from each other: a body "
            "that is far away from the origin beside its size has "
            "no digits left for its cells.");
      }
    if (formulation == "axisymmetric")
      check_axisymmetric(mesh);
    return mesh;
  }



  template <int dim>
  void
  check_axisymmetric(const Mesh<dim> &mesh)
  {
    double size = 0.;
    for (const Point<dim> &vertex : mesh.triangulation->get_vertices())
      size = std::max(size, vertex.norm());
    const double tolerance = 1e-12 * size;

    for (const auto &cell : mesh.triangulation->active_cell_iterators())
      for (const unsigned int v : cell->vertex_indices())
        if (cell->vertex(v)[0] < -tolerance)
          {
            std::ostringstream message;
            message << "x is the distance from the axis (Formulation = "
                    << "axisymmetric), so that the mesh must lie in x >= 0, "
                    << "but it has a vertex at (" << cell->vertex(v)
                    << "). Move the mesh, or mesh only its right half.";
            throw InputError("Mesh", message.str());
          }

    const auto axis = mesh.boundaries.find("axis");
    if (axis == mesh.boundaries.end())
      return;
    for (const auto &face : mesh.triangulation->active_face_iterators())
      if (face->at_boundary() && face->boundary_id() == axis->second)
        for (const unsigned int v : face->vertex_indices())
          if (std::abs(face->vertex(v)[0]) > tolerance)
            {
              std::ostringstream message;
              message << "the boundary \"axis\" must lie on x = 0 "
                      << "(Formulation = axisymmetric), but has a vertex at ("
                      << face->vertex(v)
                      << "). Give the centre the coordinate x = 0.";
              throw InputError("Mesh", message.str());
            }
  }

#define INSTANTIATE(dim)                                                     \
  template EntryConditions mesh_conditions<dim>();                           \
  template void            declare_mesh_parameters<dim>(ParameterHandler &); \
  template Mesh<dim>       create_mesh<dim>(const ParameterHandler &,        \
                                      const std::string &,             \
                                      const std::string &);            \
  template void            check_axisymmetric<dim>(const Mesh<dim> &);
  SIGNORINI_FOR_EACH_DIMENSION(INSTANTIATE)
#undef INSTANTIATE
} // namespace Signorini
