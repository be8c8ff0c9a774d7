#include <signorini/geometry/empty_mesh.h>
#include <signorini/geometry/entries.h>
#include <signorini/geometry/shapes/tube.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/manifold_lib.h>

namespace Signorini
{
  using namespace dealii;

  void
  Tube::declare_parameters(ParameterHandler &prm)
  {
    prm.enter_subsection("Tube");
    prm.declare_entry("Centre",
                      "0, 0, 0",
                      Patterns::List(Patterns::Double(), 3, 3, ","),
                      "Centre of the back end, the one with the smallest z. "
                      "Unit: m.");
    RingShape::declare_parameters(prm);
    prm.declare_entry("Length",
                      "1",
                      Patterns::Double(),
                      "Length in the direction z, greater than 0. Unit: m.");
    prm.declare_entry("Cells",
                      "24, 2, 8",
                      Patterns::List(Patterns::Integer(), 3, 3, ","),
                      "Number of cells along the circles, from the inner to "
                      "the outer one, and along the tube, at least 1.");
    prm.leave_subsection();
  }



  void
  Tube::parse_parameters(const ParameterHandler &prm)
  {
    const Entries  entries(prm, "Tube");
    const Point<3> center = entries.point<3>("Centre");
    ring.center           = Point<2>(center[0], center[1]);
    ring.parse_parameters(entries);
    back    = center[2];
    length  = entries.positive("Length");
    n_axial = entries.counts("Cells", 1)[2];
  }



  Mesh<3>
  Tube::create() const
  {
    const Mesh<2> section = ring_mesh(ring);
    Mesh<3>       mesh    = empty_mesh<3>();
    GridGenerator::extrude_triangulation(*section.triangulation,
                                         n_axial + 1,
                                         length,
                                         *mesh.triangulation);
    GridTools::shift(Point<3>(0., 0., back), *mesh.triangulation);

    // The two ends get the next free ids.
    const types::boundary_id n_sides = section.boundaries.size();
    mesh.boundaries                  = section.boundaries;
    mesh.boundaries.insert({{"back", n_sides}, {"front", n_sides + 1}});

    mesh.triangulation->set_all_manifold_ids(0);
    mesh.triangulation->set_manifold(
      0,
      CylindricalManifold<3>(Tensor<1, 3>({0., 0., 1.}),
                             Point<3>(ring.center[0], ring.center[1], 0.)));
    return mesh;
  }
} // namespace Signorini
