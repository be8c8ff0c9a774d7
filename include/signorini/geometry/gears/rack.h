#ifndef signorini_geometry_gears_rack_h
#define signorini_geometry_gears_rack_h

#include <signorini/geometry/gears/tooth_entries.h>
#include <signorini/geometry/mesh_generator.h>

namespace Signorini
{
  /**
   * `rack` (2-D, subsection `Rack`): teeth that point up, with straight flanks,
   * on a back. It meshes with a `pinion` above that has the same entries.
   *
   * `Pitch point` lies on the pitch line. `Roll angle` is that of the pinion,
   * which moves the rack to the right by the pitch radius times the angle.
   * Teeth are numbered from left to right.
   *
   * Boundaries: right_1, left_1, right_2, ... (flanks), tips, roots (the
   * fillets and what is between them), back, and the cuts start (at the left)
   * and end, in the middle of a space. Region: body.
   */
  class Rack : public MeshGenerator<2>
  {
  public:
    static void
    declare_parameters(dealii::ParameterHandler &prm);

    void
    parse_parameters(const dealii::ParameterHandler &prm) override;

    Mesh<2>
    create() const override;

  private:
    ToothEntries teeth;
    unsigned int n_pinion_teeth;
    double       back_thickness; // m
  };
} // namespace Signorini

#endif
