#ifndef signorini_geometry_gears_tooth_entries_h
#define signorini_geometry_gears_tooth_entries_h

#include <signorini/geometry/gears/gear_tooth.h>

#include <deal.II/base/point.h>

#include <string>

namespace dealii
{
  class ParameterHandler;
}

namespace Signorini
{
  class Entries;

  /**
   * What the sections of a pinion and its rack have in common. With equal
   * entries, the two mesh: the right (or left) flanks of the teeth of the same
   * number are the working ones, and at the roll angle 0 those of the tooth at
   * the pitch point touch there.
   */
  struct ToothEntries
  {
    ToothParameters  parameters;
    unsigned int     n_modelled_teeth;
    unsigned int     tooth_at_pitch_point; // from 1
    bool             right_flanks_work;
    double           roll_angle;  // degrees
    dealii::Point<2> pitch_point; // m
    unsigned int     n_cells_along_flank;

    /**
     * Declares the shape of the teeth.
     * @p relief_length says where the length of the tip relief is measured.
     */
    static void
    declare_shape(dealii::ParameterHandler &prm,
                  const std::string        &relief_length);

    /** Declares which teeth are modelled, and where they stand. */
    static void
    declare_place(dealii::ParameterHandler &prm, const std::string &motion);

    /** Checks what each number can be by itself. @throws InputError */
    static ToothEntries
    parse(const Entries &entries);
  };

  /**
   * A limit in four digits for a message, rounded to the safe side: what it
   * says is accepted.
   */
  std::string
  rounded_down(const double value);

  std::string
  rounded_up(const double value);

  /** What a tooth of a gear or a rack has become, to be checked. */
  struct ToothMeasures
  {
    double tip_thickness;         // m
    double half_land;             // m, of the root, or of the tip of its cutter
    double largest_fillet_radius; // coefficient
    double flank_length;          // m, measured as the length of the tip relief
  };

  /**
   * Refuses fillets that do not fit, no flank, tip relief longer than the
   * flank, and pointed teeth. @throws InputError naming the entry.
   */
  void
  check_tooth(const ToothMeasures   &tooth,
              const ToothParameters &parameters,
              const Entries         &entries);
} // namespace Signorini

#endif
