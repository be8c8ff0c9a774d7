#ifndef signorini_geometry_shapes_ball_h
#define signorini_geometry_shapes_ball_h

#include <signorini/geometry/mesh_generator.h>
#include <signorini/geometry/shapes/round_shape.h>

namespace Signorini
{
  /**
   * `disc` (2-D, subsection `Disc`) and `ball` (3-D, subsection `Ball`): the
   * full circle or sphere. Boundary: rim. Region: body. Coarsest mesh: 12
   * cells in 2-D, 32 in 3-D.
   */
  template <int dim>
  class Ball : public MeshGenerator<dim>
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
  };
} // namespace Signorini

#endif
