#include <signorini/geometry/entries.h>
#include <signorini/geometry/round_shape.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/grid/manifold_lib.h>
#include <deal.II/grid/tria.h>

namespace Signorini
{
  using namespace dealii;

  template <int dim>
  void
  RoundShape<dim>::declare_parameters(ParameterHandler &prm)
  {
    prm.declare_entry("Centre",
                      dim == 2 ? "0, 0" : "0, 0, 0",
                      Patterns::List(Patterns::Double(), dim, dim, ","),
                      "Centre of the circle or sphere. Unit: m.");
    prm.declare_entry("Radius",
                      "1",
                      Patterns::Double(),
                      "Radius, greater than 0. Unit: m.");
    prm.declare_entry("Initial refinements",
                      dim == 2 ? "3" : "2",
                      Patterns::Integer(),
                      "How often all cells of the coarsest mesh are cut in "
                      "half in each direction; 0 or more.");
  }



  template <int dim>
  RoundShape<dim>
  RoundShape<dim>::parse(const Entries &entries)
  {
    return {entries.point<dim>("Centre"),
            entries.positive("Radius"),
            entries.count("Initial refinements", 0)};
  }



  template <int dim>
  void
  attach_round_manifolds(Triangulation<dim>      &triangulation,
                         const Point<dim>        &center,
                         const types::boundary_id rim)
  {
    const types::manifold_id sphere = 0, inside = 1;

    triangulation.reset_all_manifolds();
    triangulation.set_all_manifold_ids(inside);
    // The cut lines of the plane stay straight to the last digit. In 3-D the
    // interpolation keeps cut faces plane and their cells well shaped.
    if (dim == 2)
      for (const auto &face : triangulation.active_face_iterators())
        if (face->at_boundary())
          face->set_all_manifold_ids(numbers::flat_manifold_id);
    for (const auto &face : triangulation.active_face_iterators())
      if (face->at_boundary() && face->boundary_id() == rim)
        face->set_all_manifold_ids(sphere);

    triangulation.set_manifold(sphere, SphericalManifold<dim>(center));
    TransfiniteInterpolationManifold<dim> interpolation;
    interpolation.initialize(triangulation);
    triangulation.set_manifold(inside, interpolation);
  }

  template struct RoundShape<2>;
  template struct RoundShape<3>;
  template void
  attach_round_manifolds<2>(Triangulation<2> &,
                            const Point<2> &,
                            const types::boundary_id);
  template void
  attach_round_manifolds<3>(Triangulation<3> &,
                            const Point<3> &,
                            const types::boundary_id);
} // namespace Signorini
