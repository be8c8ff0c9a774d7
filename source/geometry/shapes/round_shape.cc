#include <signorini/geometry/entries.h>
#include <signorini/geometry/mesh_refinement.h>
#include <signorini/geometry/shapes/round_shape.h>
#include <signorini/input/instantiate.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/grid/manifold_lib.h>
#include <deal.II/grid/tria.h>

#include <algorithm>
#include <cmath>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    template <int dim>
    void
    set_manifold_of_rim(const types::manifold_id manifold,
                        const types::boundary_id rim,
                        Triangulation<dim>      &triangulation)
    {
      for (const auto &face : triangulation.active_face_iterators())
        if (face->at_boundary() && face->boundary_id() == rim)
          face->set_all_manifold_ids(manifold);
    }

    // The interpolation is an iteration and leaves its last residual.
    template <int dim>
    void
    flatten_cuts(const RoundShape<dim>   &shape,
                 const types::boundary_id rim,
                 Triangulation<dim>      &triangulation)
    {
      for (const auto &face : triangulation.active_face_iterators())
        if (face->at_boundary() && face->boundary_id() != rim)
          for (const unsigned int v : face->vertex_indices())
            for (unsigned int d = 0; d < dim; ++d)
              {
                double &coordinate = face->vertex(v)[d];
                if (std::abs(coordinate - shape.center[d]) <
                    1e-8 * shape.radius)
                  coordinate = shape.center[d];
              }
    }
  } // namespace



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
  refine_round(const RoundShape<dim>   &shape,
               const types::boundary_id rim,
               Triangulation<dim>      &triangulation)
  {
    const types::manifold_id sphere = 0, inside = 1;
    const unsigned int       n_smooth = std::min(shape.initial_refinements, 2u);

    triangulation.reset_all_manifolds();
    triangulation.set_all_manifold_ids(inside);
    set_manifold_of_rim(sphere, rim, triangulation);
    triangulation.set_manifold(sphere, SphericalManifold<dim>(shape.center));
    TransfiniteInterpolationManifold<dim> interpolation;
    interpolation.initialize(triangulation);
    triangulation.set_manifold(inside, interpolation);
    refine_globally(triangulation, n_smooth);

    triangulation.reset_manifold(inside);
    triangulation.set_all_manifold_ids(numbers::flat_manifold_id);
    set_manifold_of_rim(sphere, rim, triangulation);
    flatten_cuts(shape, rim, triangulation);
    refine_globally(triangulation, shape.initial_refinements - n_smooth);
  }

#define INSTANTIATE(dim)                                    \
  template struct RoundShape<dim>;                          \
  template void refine_round<dim>(const RoundShape<dim> &,  \
                                  const types::boundary_id, \
                                  Triangulation<dim> &);
  SIGNORINI_FOR_EACH_DIMENSION(INSTANTIATE)
#undef INSTANTIATE
} // namespace Signorini
