#include <signorini/geometry/entries.h>
#include <signorini/geometry/gears/tooth_entries.h>

#include <deal.II/base/parameter_handler.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    ToothParameters
    parse_shape(const Entries &entries)
    {
      ToothParameters tooth;
      tooth.module         = entries.positive("Module");
      tooth.pressure_angle = entries.number("Pressure angle");
      tooth.addendum       = entries.positive("Addendum");
      tooth.dedendum       = entries.positive("Dedendum");
      tooth.profile_shift  = entries.number("Profile shift");
      tooth.fillet_radius  = entries.number("Fillet radius");
      tooth.thinning       = entries.number("Tooth thinning");
      tooth.relief         = entries.number("Tip relief");
      tooth.relief_length  = entries.number("Tip relief length");

      if (!(tooth.pressure_angle >= 10. && tooth.pressure_angle <= 35.))
        entries.refuse("Pressure angle", "must be from 10 to 35 degrees.");
      if (!(tooth.fillet_radius >= 0.05))
        entries.refuse("Fillet radius", "must be at least 0.05 modules.");
      if (!(tooth.thinning >= 0.))
        entries.refuse("Tooth thinning", "must not be negative.");
      if (!(tooth.relief >= 0.))
        entries.refuse("Tip relief", "must not be negative.");
      if (tooth.relief > 0. && !(tooth.relief_length > 0.))
        entries.refuse("Tip relief length",
                       "must be greater than zero, since Tip relief = " +
                         entries.text("Tip relief") + ".");
      if (tooth.relief > 0.1 * tooth.relief_length)
        entries.refuse("Tip relief",
                       "must not be more than a tenth of Tip relief length = " +
                         entries.text("Tip relief length") + ".");
      return tooth;
    }
  } // namespace



  std::string
  rounded_down(const double value)
  {
    // 4250 units stay 4250 when the computer finds a little less.
    const double unit =
      value == 0. ? 1. :
                    std::pow(10., std::floor(std::log10(std::abs(value))) - 3.);
    std::ostringstream text;
    text << std::floor(value / unit + 1e-6) * unit;
    return text.str();
  }



  std::string
  rounded_up(const double value)
  {
    const std::string text = rounded_down(-value);
    return text == "0" ? text : text[0] == '-' ? text.substr(1) : "-" + text;
  }



  void
  ToothEntries::declare_shape(ParameterHandler  &prm,
                              const std::string &relief_length)
  {
    prm.declare_entry("Module",
                      "0.005",
                      Patterns::Double(),
                      "Module m, the pitch divided by pi, greater "
                      "than 0. Unit: m.");
    prm.declare_entry("Pressure angle",
                      "20",
                      Patterns::Double(),
                      "From 10 to 35. Unit: degree.");
    prm.declare_entry(
      "Addendum",
      "1",
      Patterns::Double(),
      "Height of the tooth above its datum line. Unit: module.");
    prm.declare_entry("Dedendum",
                      "1.25",
                      Patterns::Double(),
                      "Depth of the tooth below its datum line. Unit: module.");
    prm.declare_entry("Profile shift",
                      "0",
                      Patterns::Double(),
                      "x: the pinion is cut with the datum line of the cutter "
                      "x modules outside the pitch circle, and that of the "
                      "rack lies as far from it. The same for both. Unit: "
                      "module.");
    prm.declare_entry("Fillet radius",
                      "0.38",
                      Patterns::Double(),
                      "Radius at the root of a rack; that of a pinion is cut "
                      "by a rack whose tip is rounded by this radius. At "
                      "least 0.05. Unit: module.");
    prm.declare_entry("Tooth thinning",
                      "0",
                      Patterns::Double(),
                      "By how much the teeth are thinner on the pitch line "
                      "than without backlash. The backlash is the sum of that "
                      "of the pinion and of the rack. Unit: m.");
    prm.declare_entry("Tip relief",
                      "0",
                      Patterns::Double(),
                      "By how much the flank is set back at the tip, along "
                      "its normal: a parabola, without a kink. Unit: m.");
    prm.declare_entry("Tip relief length",
                      "0",
                      Patterns::Double(),
                      relief_length + " Unit: m.");
  }



  void
  ToothEntries::declare_place(ParameterHandler &prm, const std::string &motion)
  {
    prm.declare_entry("Modelled teeth",
                      "3",
                      Patterns::Integer(std::numeric_limits<int>::min(), 10000),
                      "How many teeth next to each other are "
                      "modelled, from the middle of a space to the "
                      "middle of another; at least 1.");
    prm.declare_entry("Tooth at pitch point",
                      "2",
                      Patterns::Integer(),
                      "The modelled tooth, numbered from 1, whose working "
                      "flank goes through the pitch point at the roll angle "
                      "0. Tooth k of the pinion meshes with tooth k of the "
                      "rack if this entry is the same for both.");
    prm.declare_entry("Working flanks",
                      "right",
                      Patterns::Selection("right|left"),
                      "The flanks that touch, seen with the tip up. Right "
                      "flanks touch right ones: the rack pushes the pinion to "
                      "the right.");
    prm.declare_entry("Roll angle", "0", Patterns::Double(), motion);
    prm.declare_entry("Pitch point",
                      "0, 0",
                      Patterns::List(Patterns::Double(), 2, 2, ","),
                      "Where the pitch circle of the pinion touches the pitch "
                      "line of the rack below. The centre of the pinion is "
                      "half the module times its number of teeth above it. "
                      "Unit: m.");
    prm.declare_entry("Cells along a flank",
                      "8",
                      Patterns::Integer(),
                      "From 2 to 1000. The other cells get about the same "
                      "size.");
  }



  ToothEntries
  ToothEntries::parse(const Entries &entries)
  {
    ToothEntries result;
    result.parameters           = parse_shape(entries);
    result.n_modelled_teeth     = entries.count("Modelled teeth", 1);
    result.tooth_at_pitch_point = entries.count("Tooth at pitch point", 1);
    result.right_flanks_work    = entries.text("Working flanks") == "right";
    result.roll_angle           = entries.number("Roll angle");
    result.pitch_point          = entries.point<2>("Pitch point");
    result.n_cells_along_flank  = entries.count("Cells along a flank", 2);

    if (result.tooth_at_pitch_point > result.n_modelled_teeth)
      entries.refuse("Tooth at pitch point",
                     "must not be more than Modelled teeth = " +
                       entries.text("Modelled teeth") + ".");
    if (result.n_cells_along_flank > 1000)
      entries.refuse("Cells along a flank", "must not be more than 1000.");
    return result;
  }



  void
  check_tooth(const ToothMeasures   &tooth,
              const ToothParameters &parameters,
              const Entries         &entries)
  {
    if (tooth.half_land < 0.)
      entries.refuse("Fillet radius",
                     "does not fit between the teeth. Here it can be at most " +
                       rounded_down(tooth.largest_fillet_radius) +
                       "; a smaller Dedendum leaves more room.");
    if (!(tooth.flank_length > 0.1 * parameters.module))
      entries.refuse("Addendum",
                     "leaves no flank between the fillet and the tip.");
    if (parameters.relief > 0. &&
        parameters.relief_length > 0.95 * tooth.flank_length)
      entries.refuse(
        "Tip relief length",
        "must not be more than 0.95 times the length of the flank, "
        "which is " +
          rounded_down(tooth.flank_length) + " m.");

    const double smallest_tip = 0.1 * parameters.module;
    if (tooth.tip_thickness >= smallest_tip)
      return;
    const std::string rule = "the tip would be " +
                             rounded_down(std::max(tooth.tip_thickness, 0.)) +
                             " m wide; at least 0.1 modules are needed.";
    if (tooth.tip_thickness + parameters.thinning >= smallest_tip)
      entries.refuse("Tooth thinning", "thins the teeth away: " + rule);
    entries.refuse("Addendum",
                   "makes the teeth pointed: " + rule +
                     " Choose a smaller Addendum, or another Profile shift.");
  }
} // namespace Signorini
