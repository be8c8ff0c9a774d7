#ifndef signorini_geometry_shapes_round_shape_h
#define signorini_geometry_shapes_round_shape_h

#include <deal.II/base/point.h>
#include <deal.II/base/types.h>
#include <deal.II/grid/tria.h>

namespace dealii
{
  class ParameterHandler;
}

namespace Signorini
{
  class Entries;

  /** The entries that balls and their parts have in common. */
  template <int dim>
  struct RoundShape
  {
    dealii::Point<dim> center;              // m
    double             radius;              // m
    unsigned int       initial_refinements; // each halves all cells

    /** Declares Centre, Radius and Initial refinements. */
    static void
    declare_parameters(dealii::ParameterHandler &prm);

    /** @throws InputError */
    static RoundShape
    parse(const Entries &entries);
  };

  /**
   * Performs the initial refinements of a coarse mesh whose faces with the
   * boundary id @p rim lie on the sphere; other faces of the boundary lie in
   * cuts through the centre, perpendicular to an axis.
   *
   * The first two refinements spread the curvature over the inner cells
   * (transfinite interpolation), so that their size varies smoothly. Then only
   * the rim is curved, for good: every later refinement puts its new vertices
   * on the sphere. This is fast, and cells that fine hardly differ any more.
   * Cuts are plane to the last digit.
   */
  template <int dim>
  void
  refine_round(const RoundShape<dim>           &shape,
               const dealii::types::boundary_id rim,
               dealii::Triangulation<dim>      &triangulation);
} // namespace Signorini

#endif
