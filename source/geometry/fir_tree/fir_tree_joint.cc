#include <signorini/geometry/degrees.h>
#include <signorini/geometry/entries.h>
#include <signorini/geometry/fir_tree/fir_tree_joint.h>
#include <signorini/geometry/fir_tree/fir_tree_profile.h>

#include <deal.II/base/parameter_handler.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    std::string
    in_words(const double number)
    {
      std::ostringstream stream;
      stream.precision(4);
      stream << number;
      return stream.str();
    }

    double
    number_between(const Entries     &entries,
                   const std::string &entry,
                   const double       minimum,
                   const double       maximum)
    {
      const double value = entries.number(entry);
      if (!(value >= minimum && value <= maximum))
        entries.refuse(entry,
                       "must be from " + in_words(minimum) + " to " +
                         in_words(maximum) + ".");
      return value;
    }

    void
    check_angles(const FirTreeJoint &joint, const Entries &entries)
    {
      const double tooth_angle = joint.contact_angle + joint.back_angle;
      if (!(tooth_angle >= 30. && tooth_angle <= 120.))
        entries.refuse("Back flank angle",
                       "together with Contact angle = " +
                         entries.text("Contact angle") +
                         " it must be from 30 to 120.");
      if (!(joint.back_angle + joint.taper_angle <= 75.))
        entries.refuse("Taper angle",
                       "together with Back flank angle = " +
                         entries.text("Back flank angle") +
                         " it must not be greater than 75, or the teeth "
                         "become too long.");
    }

    // A back flank too short has no room between its two arcs.
    void
    check_flanks(const FirTreeJoint &joint, const Entries &entries)
    {
      if (!(joint.back_flank_length() >= 0.1 * joint.flank_length))
        entries.refuse("Flank length",
                       "the arcs of root and tip do not fit: the straight part "
                       "of the back flank would have the length " +
                         in_words(joint.back_flank_length()) +
                         " m, and must have a tenth of the flank length. Take "
                         "a longer flank, smaller radii or angles nearer to "
                         "each other.");
      const double smallest = 0.5 * joint.bottom_neck_width;
      if (!(smallest >= joint.root_radius))
        entries.refuse("Bottom neck width",
                       "must not be less than twice Root radius = " +
                         entries.text("Root radius") + ".");
    }

    void
    check_clearance(const FirTreeJoint &joint, const Entries &entries)
    {
      // The tips of the disc's teeth keep a fifth of the radius of the fillet.
      const double largest = 0.8 * joint.root_radius *
                             std::min(1. - sin_degrees(joint.contact_angle),
                                      1. - cos_degrees(joint.tip_turn()));
      if (!(joint.clearance >= 0. && joint.clearance <= largest))
        entries.refuse("Clearance",
                       "must be from 0 to " + limit_in_words(largest) +
                         ", so that the tips of the disc's teeth stay round "
                         "within Root radius = " +
                         entries.text("Root radius") + ".");
    }

    void
    check_bottom(const FirTreeJoint &joint, const Entries &entries)
    {
      // The end of the last tip, where the back flank begins.
      const double alpha = joint.contact_angle, beta = joint.back_angle;
      const double x =
        joint.neck(joint.n_teeth) +
        joint.root_radius * (1. - sin_degrees(alpha)) +
        joint.flank_length * cos_degrees(alpha) +
        joint.tip_radius * (sin_degrees(beta) - sin_degrees(alpha));
      const double shortest = 0.5 * joint.flank_length;
      const double largest =
        (x - shortest * cos_degrees(beta)) / sin_degrees(beta);
      if (!(joint.bottom_radius >= joint.root_radius &&
            joint.bottom_radius <= largest))
        entries.refuse("Bottom radius",
                       "must be from Root radius = " +
                         entries.text("Root radius") + " to " +
                         limit_in_words(largest) +
                         ", so that half the flank length is left for the "
                         "last back flank.");
    }

    void
    check_rim(const FirTreeJoint &joint, const Entries &entries)
    {
      const double mouth = joint.neck(1) + joint.clearance;
      if (!(joint.rim_radius > mouth))
        entries.refuse("Rim radius",
                       "must be greater than half the width of the slot's "
                       "mouth, " +
                         in_words(mouth) + " m.");
      const double bottom = slot_profile(joint).back().end[1];
      if (!(bottom > 0.))
        entries.refuse("Rim radius",
                       "the slot would be deeper than the disc, by " +
                         in_words(-bottom) + " m.");
    }

    void
    check_blades(const FirTreeJoint &joint, const Entries &entries)
    {
      const double smallest = 0.5 * joint.root_radius;
      const double neck     = disc_neck(joint);
      if (neck >= smallest)
        return;

      FirTreeJoint fewer = joint;
      while (fewer.n_blades > 3 && disc_neck(fewer) < smallest)
        --fewer.n_blades;
      entries.refuse("Blades",
                     (neck > 0. ?
                        "neighbouring slots leave only " + in_words(2. * neck) +
                          " m between them, and must leave Root radius = " +
                          entries.text("Root radius") + "." :
                        std::string("neighbouring slots overlap.")) +
                       (disc_neck(fewer) < smallest ?
                          " The disc is too small for any number of blades." :
                          " At most " + std::to_string(fewer.n_blades) +
                            " blades fit on this rim."));
    }
  } // namespace



  void
  FirTreeJoint::parse_parameters(const Entries &entries)
  {
    n_teeth           = entries.count("Teeth", 1);
    flank_length      = entries.positive("Flank length");
    contact_angle     = number_between(entries, "Contact angle", 5., 60.);
    back_angle        = number_between(entries, "Back flank angle", 5., 70.);
    taper_angle       = number_between(entries, "Taper angle", 0., 30.);
    root_radius       = entries.positive("Root radius");
    tip_radius        = entries.positive("Tip radius");
    bottom_radius     = entries.positive("Bottom radius");
    bottom_neck_width = entries.positive("Bottom neck width");
    clearance         = entries.number("Clearance");
    mouth_depth       = entries.positive("Mouth depth");
    rim_radius        = entries.positive("Rim radius");
    n_blades          = entries.count("Blades", 3);
    if (n_teeth > 6)
      entries.refuse("Teeth", "must be from 1 to 6.");

    check_angles(*this, entries);
    check_flanks(*this, entries);
    check_clearance(*this, entries);
    check_bottom(*this, entries);
    check_rim(*this, entries);
    check_blades(*this, entries);
  }



  double
  FirTreeJoint::pitch() const
  {
    return (flank_length * sin_degrees(contact_angle + back_angle) +
            (root_radius + tip_radius) *
              (1. + cos_degrees(contact_angle + back_angle))) /
           cos_degrees(back_angle + taper_angle);
  }



  double
  FirTreeJoint::back_flank_length() const
  {
    return (flank_length * cos_degrees(contact_angle - taper_angle) +
            (root_radius + tip_radius) *
              (sin_degrees(back_angle + taper_angle) -
               sin_degrees(contact_angle - taper_angle))) /
           cos_degrees(back_angle + taper_angle);
  }



  double
  FirTreeJoint::tip_turn() const
  {
    return 180. - contact_angle - back_angle;
  }



  double
  FirTreeJoint::neck(const unsigned int tooth) const
  {
    return 0.5 * bottom_neck_width +
           (n_teeth - tooth) * pitch() * sin_degrees(taper_angle);
  }



  double
  FirTreeJoint::radius_difference(const double angle) const
  {
    return clearance / (1. - cos_degrees(angle));
  }



  std::string
  limit_in_words(const double limit)
  {
    if (!(limit > 0.))
      return in_words(limit);
    const double unit = std::pow(10., std::floor(std::log10(limit)) - 3.);
    return in_words(std::floor(limit / unit) * unit);
  }
} // namespace Signorini
