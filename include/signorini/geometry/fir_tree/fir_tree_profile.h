#ifndef signorini_geometry_fir_tree_fir_tree_profile_h
#define signorini_geometry_fir_tree_fir_tree_profile_h

#include <signorini/geometry/fir_tree/fir_tree_joint.h>

#include <deal.II/base/point.h>

#include <vector>

namespace Signorini
{
  /** A straight piece or a circular arc of a profile. */
  struct ProfilePiece
  {
    enum class Kind
    {
      side,   // the shank of the blade, the mouth of the slot
      fillet, // round the necks of the blade
      contact,
      tip, // round the tips of the blade's teeth
      back,
      bottom
    };

    Kind             kind;
    unsigned int     tooth; // 1 is the one nearest the rim
    dealii::Point<2> start; // m
    dealii::Point<2> end;   // m
    dealii::Point<2> center;
    double           turn; // degrees, counter-clockwise; 0 for a straight piece

    bool
    is_arc() const;

    /** Of an arc. Unit: m. */
    double
    radius() const;

    /** The point after this fraction of the length; the ends are exact. */
    dealii::Point<2>
    at(const double fraction) const;

    /** The unit vector along the piece, at this fraction of its length. */
    dealii::Tensor<1, 2>
    tangent(const double fraction) const;

    /** The part between two fractions of the length. */
    ProfilePiece
    part(const double begin, const double end) const;
  };

  /**
   * The right half of the blade root from the top of the shank down to the y
   * axis: side, then for each tooth fillet, contact, tip and back, then bottom.
   * Each piece is tangent to the next one.
   * @param shank_height length of the side above the top fillet, m
   */
  std::vector<ProfilePiece>
  blade_profile(const FirTreeJoint &joint, const double shank_height);

  /**
   * The right half of the slot from the rim down to the y axis, with the same
   * pieces. Its working flanks are those of the blade, with the same ends.
   * Side, back flanks and bottom have the clearance from the blade. (Where a
   * tip of the disc of radius R begins, the blade's fillet of radius r has
   * begun already: there it is a bit less, but more than R/r of it.) The arcs
   * that begin at a working flank leave those of the blade gradually: a jump
   * would need a corner.
   */
  std::vector<ProfilePiece>
  slot_profile(const FirTreeJoint &joint);

  /**
   * What is left of the disc between the axis of symmetry between two slots and
   * the slot at its widest tooth: half the narrowest neck of the disc, m. Zero
   * or less if the slots overlap.
   */
  double
  disc_neck(const FirTreeJoint &joint);
} // namespace Signorini

#endif
