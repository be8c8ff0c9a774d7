#ifndef signorini_geometry_shapes_quarter_disc_h
#define signorini_geometry_shapes_quarter_disc_h

#include <signorini/geometry/mesh_generator.h>
#include <signorini/geometry/shapes/round_shape.h>

#include <string>

namespace Signorini
{
  /**
   * `half ball` in 2-D (subsection `Half ball`): the quarter disc to the right
   * of its centre, that is, half a ball in an axisymmetric problem, or half of
   * a half disc in a plane problem with symmetry.
   *
   * `Flat side` is bottom or top; with top the round side points down.
   * Boundaries: rim, flat (perpendicular to y), axis (perpendicular to x).
   * Region: body. Coarsest mesh: 3 cells.
   */
  class QuarterDisc : public MeshGenerator<2>
  {
  public:
    static void
    declare_parameters(dealii::ParameterHandler &prm);

    void
    parse_parameters(const dealii::ParameterHandler &prm) override;

    Mesh<2>
    create() const override;

  private:
    RoundShape<2> shape;
    bool          flat_side_at_top;
  };
} // namespace Signorini

#endif
