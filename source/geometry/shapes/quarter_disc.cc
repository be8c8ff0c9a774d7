#include <signorini/geometry/empty_mesh.h>
#include <signorini/geometry/entries.h>
#include <signorini/geometry/shapes/quarter_disc.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>

namespace Signorini
{
  using namespace dealii;

  void
  QuarterDisc::declare_parameters(ParameterHandler &prm)
  {
    prm.enter_subsection("Half ball");
    RoundShape<2>::declare_parameters(prm);
    prm.declare_entry("Flat side",
                      "top",
                      Patterns::Selection("bottom|top"),
                      "The side of the body on which the cut is; with top the "
                      "round side points down.");
    prm.leave_subsection();
  }



  void
  QuarterDisc::parse_parameters(const ParameterHandler &prm)
  {
    const Entries entries(prm, "Half ball");
    shape            = RoundShape<2>::parse(entries);
    flat_side_at_top = entries.text("Flat side") == "top";
  }



  Mesh<2>
  QuarterDisc::create() const
  {
    // deal.II's quarter disc lies in x, y >= 0, and gives both cuts one id.
    Mesh<2> mesh = empty_mesh<2>();
    GridGenerator::quarter_hyper_ball(*mesh.triangulation,
                                      Point<2>(),
                                      shape.radius);
    const types::boundary_id flat = 1, axis = 2;
    mesh.boundaries = {{"rim", 0}, {"flat", flat}, {"axis", axis}};
    for (const auto &face : mesh.triangulation->active_face_iterators())
      if (face->at_boundary() && face->boundary_id() == 1)
        {
          const Point<2> middle = face->center();
          const bool     on_x   = middle[1] < 1e-3 * shape.radius;
          // Turning the mesh by a right angle below exchanges the two.
          face->set_boundary_id(on_x != flat_side_at_top ? flat : axis);
        }

    GridTools::transform(
      [&](const Point<2> &p) {
        return flat_side_at_top ? shape.center + Point<2>(p[1], -p[0]) :
                                  shape.center + p;
      },
      *mesh.triangulation);

    refine_round(shape, 0, *mesh.triangulation);
    return mesh;
  }
} // namespace Signorini
