#include <signorini/geometry/fir_tree/fir_tree_layer.h>

#include <algorithm>
#include <cmath>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    using Kind = ProfilePiece::Kind;

    class BladeLayer
    {
    public:
      BladeLayer(const FirTreeJoint &joint,
                 const FirTreeCells &cells,
                 const double        shank_height,
                 const unsigned int  n_shank);

      FirTreeBand
      band() const;

    private:
      const FirTreeJoint &joint;
      const FirTreeCells &cells;
      const unsigned int  n_shank;

    public:
      const std::vector<ProfilePiece> profile;
      const double                    thickness;

    private:
      double
      thickness_of_layer() const;

      unsigned int
      n_floor(const ProfilePiece &piece) const;

      std::vector<double>
      fractions(const ProfilePiece &piece) const;
    };



    // The last back flank often goes far down to the middle. What is longer
    // than other back flanks belongs to the floor of the body, as the bottom
    // does.
    std::vector<ProfilePiece>
    profile_with_floor(const FirTreeJoint &joint,
                       const double        shank_height,
                       const unsigned int  n_floor)
    {
      std::vector<ProfilePiece> profile = blade_profile(joint, shank_height);
      const ProfilePiece        last    = profile[profile.size() - 2];
      const double              part =
        joint.back_flank_length() / last.start.distance(last.end);
      if (part > 0.8 || n_floor == 1)
        return profile;
      profile[profile.size() - 2] = last.part(0., part);
      profile.insert(profile.end() - 1, last.part(part, 1.));
      profile[profile.size() - 2].kind = Kind::bottom;
      return profile;
    }



    BladeLayer::BladeLayer(const FirTreeJoint &joint,
                           const FirTreeCells &cells,
                           const double        shank_height,
                           const unsigned int  n_shank)
      : joint(joint)
      , cells(cells)
      , n_shank(n_shank)
      , profile(profile_with_floor(joint, shank_height, cells.n_core))
      , thickness(thickness_of_layer())
    {}



    double
    BladeLayer::thickness_of_layer() const
    {
      double result = std::min({0.8 * joint.root_radius,
                                0.15 * joint.bottom_neck_width,
                                0.7 * joint.flank_length,
                                0.7 * joint.back_flank_length()});
      for (unsigned int tooth = 0; tooth < joint.n_teeth; ++tooth)
        result = std::min(result,
                          layer_in_tooth(profile[4 * tooth + 2],
                                         profile[4 * tooth + 4]));
      return result;
    }



    // The floor has as many cells as the lines from the teeth to the middle.
    unsigned int
    BladeLayer::n_floor(const ProfilePiece &piece) const
    {
      if (profile.size() == 4 * joint.n_teeth + 2)
        return cells.n_core;
      const ProfilePiece &flat  = profile[profile.size() - 2];
      const double        share = flat.start.distance(flat.end) /
                           (flat.start.distance(flat.end) +
                            profile.back().start.distance(profile.back().end));
      const unsigned int n_flat =
        std::clamp(static_cast<unsigned int>(std::lround(share * cells.n_core)),
                   1u,
                   cells.n_core - 1);
      return piece.is_arc() ? cells.n_core - n_flat : n_flat;
    }



    std::vector<double>
    BladeLayer::fractions(const ProfilePiece &piece) const
    {
      switch (piece.kind)
        {
          case Kind::side:
            {
              // The smallest cells at the fillet.
              std::vector<double> result =
                growing_fractions(n_shank,
                                  thickness / cells.n_layer /
                                    piece.start.distance(piece.end));
              std::reverse(result.begin(), result.end());
              for (double &fraction : result)
                fraction = 1. - fraction;
              return result;
            }
          case Kind::fillet:
            return equal_fractions(
              piece.tooth == 1 ?
                2 * n_half_first_fillet(joint, cells.n_fillet) :
                cells.n_fillet);
          case Kind::tip:
            return equal_fractions(cells.n_tip);
          case Kind::bottom:
            return equal_fractions(n_floor(piece));
          default:
            return equal_fractions(cells.n_flank);
        }
    }



    FirTreeBand
    BladeLayer::band() const
    {
      const double tip  = layer_at_tip(joint, joint.tip_radius, thickness);
      const double lean = lean_at_tip(joint);

      std::vector<FirTreeBand::Piece> pieces;
      std::vector<Polyline>           across;
      const auto                      add_across = [&](const Point<2> &vertex,
                                  const Point<2> &inner) {
        across.push_back(
          straight_line(vertex, inner, equal_fractions(cells.n_layer)));
      };
      for (const ProfilePiece &piece : profile)
        {
          const bool is_round  = piece.is_arc() && piece.kind != Kind::tip;
          const bool after_tip = piece.kind == Kind::back;
          pieces.push_back({piece, fractions(piece), is_round});
          add_across(
            piece.start,
            piece.kind == Kind::tip || after_tip ?
              inner_point(piece, false, tip, after_tip ? lean : -lean) :
              inner_point(piece, false, thickness, 0.));
        }
      const Point<2> lowest = profile.back().end;
      add_across(lowest, lowest + Tensor<1, 2>({0., thickness}));
      return FirTreeBand(pieces, across);
    }
  } // namespace



  FirTreeLayer
  blade_root_layer(const FirTreeJoint &joint,
                   const FirTreeCells &cells,
                   const double        shank_height,
                   const unsigned int  n_shank)
  {
    const BladeLayer layer(joint, cells, shank_height, n_shank);
    return {layer.profile, layer.thickness, layer.band()};
  }
} // namespace Signorini
