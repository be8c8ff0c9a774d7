#include <signorini/geometry/entries.h>
#include <signorini/geometry/gears/pinion.h>
#include <signorini/geometry/gears/tooth_mesh.h>

#include <deal.II/base/numbers.h>
#include <deal.II/base/parameter_handler.h>

#include <limits>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    void
    check_cutting(const GearTooth       &tooth,
                  const ToothParameters &parameters,
                  const Entries         &entries)
    {
      if (!(parameters.profile_shift < parameters.dedendum))
        entries.refuse("Profile shift",
                       "must be less than Dedendum = " +
                         entries.text("Dedendum") +
                         ", or the cutter does not reach the pitch circle.");
      if (tooth.begin_of_involute() < 0.)
        entries.refuse(
          "Profile shift",
          "the teeth would be undercut. With this number of teeth, the profile "
          "shift must be at least " +
            rounded_up(tooth.smallest_profile_shift()) +
            "; more Teeth, a smaller Dedendum or a larger Fillet radius help "
            "as well.");
    }

    ToothRow
    row_of_pinion(const ToothEntries &teeth, const unsigned int n_teeth)
    {
      const double radius = GearTooth(n_teeth, teeth.parameters).pitch_radius();
      const double pitch  = 2. * numbers::PI / n_teeth;
      const double half_thickness =
        GearTooth(n_teeth, teeth.parameters).pitch_thickness() / (2. * radius);

      // Angles are clockwise, and pi is down, where the pitch point is.
      const double axis_at_pitch_point =
        numbers::PI +
        (teeth.right_flanks_work ? -half_thickness : half_thickness) -
        teeth.roll_angle * numbers::PI / 180.;
      return {true,
              teeth.pitch_point + Point<2>(0., radius),
              axis_at_pitch_point + (teeth.tooth_at_pitch_point - 1.) * pitch,
              pitch,
              teeth.n_modelled_teeth};
    }
  } // namespace



  void
  Pinion::declare_parameters(ParameterHandler &prm)
  {
    prm.enter_subsection("Pinion");
    prm.declare_entry("Teeth",
                      "20",
                      Patterns::Integer(std::numeric_limits<int>::min(), 10000),
                      "Number of teeth z of the whole gear, at least 5.");
    ToothEntries::declare_shape(prm,
                                "Where the tip relief begins, measured on the "
                                "line of action from the end of the contact "
                                "at the tip.");
    prm.declare_entry("Bore radius",
                      "0.03",
                      Patterns::Double(),
                      "At least a quarter of a module below the root circle. "
                      "Unit: m.");
    ToothEntries::declare_place(prm,
                                "Turns the pinion counter-clockwise about its "
                                "centre. Unit: degree.");
    prm.leave_subsection();
  }



  void
  Pinion::parse_parameters(const ParameterHandler &prm)
  {
    const Entries entries(prm, "Pinion");
    teeth       = ToothEntries::parse(entries);
    n_teeth     = entries.count("Teeth", 5);
    bore_radius = entries.positive("Bore radius");
    if (teeth.n_modelled_teeth > n_teeth)
      entries.refuse("Modelled teeth",
                     "must not be more than Teeth = " + entries.text("Teeth") +
                       ".");

    const GearTooth tooth(n_teeth, teeth.parameters);
    check_cutting(tooth, teeth.parameters, entries);
    check_tooth({tooth.tip_thickness(),
                 tooth.half_land_of_cutter(),
                 tooth.largest_fillet_radius(),
                 tooth.end_of_involute() - tooth.begin_of_involute()},
                teeth.parameters,
                entries);

    const double largest_bore =
      tooth.root_radius() - 0.25 * teeth.parameters.module;
    if (!(bore_radius <= largest_bore * (1. + 1e-12)))
      entries.refuse(
        "Bore radius",
        "must be at least a quarter of a module less than the root "
        "radius, here at most " +
          rounded_down(largest_bore) + " m.");
  }



  Mesh<2>
  Pinion::create() const
  {
    return tooth_mesh(GearTooth(n_teeth, teeth.parameters).half_tooth(),
                      row_of_pinion(teeth, n_teeth),
                      bore_radius,
                      "bore",
                      teeth.n_cells_along_flank);
  }
} // namespace Signorini
