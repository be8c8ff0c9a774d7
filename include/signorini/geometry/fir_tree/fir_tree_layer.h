#ifndef signorini_geometry_fir_tree_fir_tree_layer_h
#define signorini_geometry_fir_tree_fir_tree_layer_h

#include <signorini/geometry/fir_tree/fir_tree_band.h>

#include <vector>

namespace Signorini
{
  /** The layer of cells along the surface of one body of a fir-tree joint. */
  struct FirTreeLayer
  {
    std::vector<ProfilePiece> profile;
    double                    thickness; // along fillets, m
    FirTreeBand               band;      // one piece for each of the profile
  };

  /**
   * The layer of a blade root, x >= 0. The piece 0 is the shank; 1 + 4k to
   * 4 + 4k are the fillet, the working flank, the tip and the back flank of the
   * tooth k = 0, 1, ... Behind them comes the floor, which has `n_core` cells:
   * the bottom, and before it what the last back flank is longer than others.
   * @param shank_height above the top fillet, m
   * @param n_shank cells along the shank
   */
  FirTreeLayer
  blade_root_layer(const FirTreeJoint &joint,
                   const FirTreeCells &cells,
                   const double        shank_height,
                   const unsigned int  n_shank);

  /**
   * The layer of a disc around a slot, x >= 0. The pieces 0 to 3 are the mouth,
   * two halves of the first tip of the disc, and the first working flank; 4k,
   * 4k + 1, 4k + 2 and 4k + 3 are then the fillet around the tip of the blade's
   * tooth k = 1, 2, ..., the back flank, the tip of the disc's next tooth and
   * its working flank. Behind the last back flank comes the bottom.
   * @param bore_radius m
   */
  FirTreeLayer
  disc_sector_layer(const FirTreeJoint &joint,
                    const FirTreeCells &cells,
                    const double        bore_radius);

  /**
   * Cells along each half of the first fillet, if others have @p n_fillet. Both
   * bodies cut it in half, so that their cells can match.
   */
  unsigned int
  n_half_first_fillet(const FirTreeJoint &joint, const unsigned int n_fillet);

  /**
   * The point at the distance @p thickness from the vertex where @p piece
   * begins, on the side of the body.
   * @param body_is_left seen along the profile, the body is on the left
   * @param lean degrees from the normal of the surface towards the piece
   */
  dealii::Point<2>
  inner_point(const ProfilePiece &piece,
              const bool          body_is_left,
              const double        thickness,
              const double        lean);

  /**
   * The thickness of layers on both flanks of a tooth with which half of the
   * tooth is left between them, measured from each end of its base. Unit: m.
   * @param first the flank that begins at the base
   * @param second the flank that ends there
   */
  double
  layer_in_tooth(const ProfilePiece &first, const ProfilePiece &second);

  /**
   * The thickness of the layer at both ends of the tip of a tooth, m.
   * @param radius of the tip, m
   * @param layer its thickness elsewhere, m
   */
  double
  layer_at_tip(const FirTreeJoint &joint,
               const double        radius,
               const double        layer);

  /**
   * The lines across the layer at the ends of a tip lean away from the tip, so
   * that the three angles where they meet its inner chord are nearly even.
   * Unit: degree.
   */
  double
  lean_at_tip(const FirTreeJoint &joint);
} // namespace Signorini

#endif
