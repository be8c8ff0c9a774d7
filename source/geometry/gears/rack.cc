#include <signorini/geometry/entries.h>
#include <signorini/geometry/gears/rack.h>
#include <signorini/geometry/gears/rack_tooth.h>
#include <signorini/geometry/gears/tooth_mesh.h>

#include <deal.II/base/numbers.h>
#include <deal.II/base/parameter_handler.h>

#include <limits>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    ToothRow
    row_of_rack(const ToothEntries &teeth, const unsigned int n_pinion_teeth)
    {
      const double pitch = numbers::PI * teeth.parameters.module;
      const double half_thickness =
        RackTooth(teeth.parameters).pitch_thickness() / 2.;
      const double pitch_radius =
        GearTooth(n_pinion_teeth, teeth.parameters).pitch_radius();

      const double axis_at_pitch_point =
        (teeth.right_flanks_work ? -half_thickness : half_thickness) +
        pitch_radius * teeth.roll_angle * numbers::PI / 180.;
      return {false,
              teeth.pitch_point,
              axis_at_pitch_point - (teeth.tooth_at_pitch_point - 1.) * pitch,
              pitch,
              teeth.n_modelled_teeth};
    }
  } // namespace



  void
  Rack::declare_parameters(ParameterHandler &prm)
  {
    prm.enter_subsection("Rack");
    ToothEntries::declare_shape(prm,
                                "Where the tip relief begins, measured along "
                                "the flank from the tip.");
    prm.declare_entry("Back thickness",
                      "0.01",
                      Patterns::Double(),
                      "From the root to the back, at least a quarter of a "
                      "module. Unit: m.");
    prm.declare_entry("Teeth of the pinion",
                      "20",
                      Patterns::Integer(std::numeric_limits<int>::min(), 10000),
                      "How far the rack moves with the roll angle depends on "
                      "them; at least 5.");
    ToothEntries::declare_place(prm,
                                "By how much the pinion is turned "
                                "counter-clockwise, which moves the rack to "
                                "the right. Unit: degree.");
    prm.leave_subsection();
  }



  void
  Rack::parse_parameters(const ParameterHandler &prm)
  {
    const Entries entries(prm, "Rack");
    teeth          = ToothEntries::parse(entries);
    n_pinion_teeth = entries.count("Teeth of the pinion", 5);
    back_thickness = entries.positive("Back thickness");

    const RackTooth tooth(teeth.parameters);
    check_tooth({tooth.tip_thickness(),
                 tooth.half_land_of_root(),
                 tooth.largest_fillet_radius(),
                 tooth.flank_length()},
                teeth.parameters,
                entries);
    if (!(back_thickness >= 0.25 * teeth.parameters.module))
      entries.refuse("Back thickness",
                     "must be at least a quarter of Module = " +
                       entries.text("Module") + ".");
  }



  Mesh<2>
  Rack::create() const
  {
    const RackTooth tooth(teeth.parameters);
    return tooth_mesh(tooth.half_tooth(),
                      row_of_rack(teeth, n_pinion_teeth),
                      tooth.root_height() - back_thickness,
                      "back",
                      teeth.n_cells_along_flank);
  }
} // namespace Signorini
