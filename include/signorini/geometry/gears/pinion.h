#ifndef signorini_geometry_gears_pinion_h
#define signorini_geometry_gears_pinion_h

#include <signorini/geometry/gears/tooth_entries.h>
#include <signorini/geometry/mesh_generator.h>

namespace Signorini
{
  /**
   * `pinion` (2-D, subsection `Pinion`): some or all teeth of a spur gear, with
   * the exact profile that a rack-type cutter makes, down to a bore.
   *
   * The centre lies a pitch radius, m z/2, above `Pitch point`; there, the gear
   * meshes with a `rack` below. A positive `Roll angle` turns it
   * counter-clockwise. Teeth are numbered counter-clockwise, like those of the
   * rack from left to right, so that tooth k meshes with tooth k.
   *
   * Boundaries: right_1, left_1, right_2, ... (flanks from the end of the
   * fillet to the tip; right and left as seen with the tip up, so that right
   * flanks touch right flanks), tips, roots (the fillets and what is between
   * them), bore, and, unless all teeth are modelled, the cuts start (before
   * tooth 1) and end, in the middle of a space. Region: body.
   */
  class Pinion : public MeshGenerator<2>
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
    unsigned int n_teeth;
    double       bore_radius; // m
  };
} // namespace Signorini

#endif
