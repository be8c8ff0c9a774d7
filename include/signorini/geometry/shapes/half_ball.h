#ifndef signorini_geometry_shapes_half_ball_h
#define signorini_geometry_shapes_half_ball_h

#include <signorini/geometry/mesh_generator.h>
#include <signorini/geometry/shapes/round_shape.h>

#include <string>

namespace Signorini
{
  /**
   * `half disc` (2-D, subsection `Half disc`) and `half ball` (3-D, subsection
   * `Half ball`).
   *
   * `Flat side` says where the cut is: left, right (the cut is perpendicular
   * to x), bottom, top (to y) and in 3-D back, front (to z). With the flat
   * side at the top, the round side points down. The centre lies in the cut.
   * Boundaries: rim, flat. Region: body. Coarsest mesh: 4 cells in 2-D, 6 in
   * 3-D.
   */
  template <int dim>
  class HalfBall : public MeshGenerator<dim>
  {
  public:
    static void
    declare_parameters(dealii::ParameterHandler &prm);

    void
    parse_parameters(const dealii::ParameterHandler &prm) override;

    Mesh<dim>
    create() const override;

  private:
    RoundShape<dim> shape;
    std::string     flat_side;
  };
} // namespace Signorini

#endif
