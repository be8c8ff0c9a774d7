#ifndef signorini_geometry_shapes_tube_h
#define signorini_geometry_shapes_tube_h

#include <signorini/geometry/mesh_generator.h>
#include <signorini/geometry/shapes/ring.h>

namespace Signorini
{
  /**
   * `tube` (3-D, subsection `Tube`): a ring, or a part of it, drawn out in the
   * direction z. Boundaries: inner, outer, back (smallest z), front (largest
   * z), and the cuts start and end. Region: body.
   */
  class Tube : public MeshGenerator<3>
  {
  public:
    static void
    declare_parameters(dealii::ParameterHandler &prm);

    void
    parse_parameters(const dealii::ParameterHandler &prm) override;

    Mesh<3>
    create() const override;

  private:
    RingShape    ring;
    double       back;    // smallest z, m
    double       length;  // m
    unsigned int n_axial; // cells
  };
} // namespace Signorini

#endif
