#ifndef signorini_geometry_round_shape_h
#define signorini_geometry_round_shape_h

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
   * Makes refinement follow the sphere around @p center on the faces with the
   * boundary id @p rim, and spreads the curvature over the inner cells
   * (transfinite interpolation from the coarse cells), so that their size
   * varies smoothly.
   */
  template <int dim>
  void
  attach_round_manifolds(dealii::Triangulation<dim>      &triangulation,
                         const dealii::Point<dim>        &center,
                         const dealii::types::boundary_id rim);
} // namespace Signorini

#endif
