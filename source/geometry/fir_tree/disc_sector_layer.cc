#include <signorini/geometry/degrees.h>
#include <signorini/geometry/fir_tree/fir_tree_layer.h>

#include <algorithm>
#include <cmath>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    using Kind = ProfilePiece::Kind;

    std::vector<ProfilePiece>
    profile_with_split_tip(const FirTreeJoint &joint)
    {
      std::vector<ProfilePiece> profile = slot_profile(joint);
      const ProfilePiece        tip     = profile[1];
      profile[1]                        = tip.part(0.5, 1.);
      profile.insert(profile.begin() + 1, tip.part(0., 0.5));
      return profile;
    }



    class DiscLayer
    {
    public:
      DiscLayer(const FirTreeJoint &joint,
                const FirTreeCells &cells,
                const double        bore_radius)
        : joint(joint)
        , cells(cells)
        , bore_radius(bore_radius)
        , profile(profile_with_split_tip(joint))
        , thickness(thickness_of_layer())
      {}

      FirTreeBand
      band() const;

    private:
      const FirTreeJoint &joint;
      const FirTreeCells &cells;
      const double        bore_radius;

    public:
      const std::vector<ProfilePiece> profile;
      const double                    thickness;

    private:
      double
      thickness_of_layer() const;

      std::vector<double>
      fractions(const ProfilePiece &piece) const;

      Point<2>
      on_rim(const double x) const;

      std::vector<Point<2>>
      inner_points_of_first_tooth() const;

      std::vector<Point<2>>
      inner_points() const;
    };



    double
    DiscLayer::thickness_of_layer() const
    {
      const double below  = profile.back().end[1] - bore_radius;
      double       result = std::min({0.8 * profile[4].radius(),
                                      0.3 * disc_neck(joint),
                                      0.3 * below,
                                      2. * profile[1].radius(),
                                      0.7 * joint.flank_length,
                                      0.7 * joint.back_flank_length()});
      result = std::min(result, layer_in_tooth(profile[0], profile[3]));
      for (unsigned int v = 5; v + 3 < profile.size(); v += 4)
        result = std::min(result, layer_in_tooth(profile[v], profile[v + 2]));
      return result;
    }



    std::vector<double>
    DiscLayer::fractions(const ProfilePiece &piece) const
    {
      const auto n_along = [](const double n) {
        return equal_fractions(static_cast<unsigned int>(std::ceil(n - 1e-9)));
      };
      switch (piece.kind)
        {
          case Kind::side:
            return n_along(cells.n_flank * piece.start.distance(piece.end) /
                           joint.flank_length);
          case Kind::fillet:
            return equal_fractions(piece.tooth == 1 ?
                                     n_half_first_fillet(joint, cells.n_tip) :
                                     cells.n_tip);
          case Kind::tip:
            return equal_fractions(cells.n_fillet);
          case Kind::bottom:
            return n_along(cells.n_flank * piece.end.distance(piece.start) /
                           joint.flank_length / 2.);
          default:
            return equal_fractions(cells.n_flank);
        }
    }



    Point<2>
    DiscLayer::on_rim(const double x) const
    {
      return Point<2>(x,
                      std::sqrt(joint.rim_radius * joint.rim_radius - x * x));
    }



    // The corner lies where lines parallel to the side and to the working flank
    // meet, on the middle line of the tip; but within the body.
    std::vector<Point<2>>
    DiscLayer::inner_points_of_first_tooth() const
    {
      const ProfilePiece &tip  = profile[1];
      const double        here = std::min(thickness, 1.2 * tip.radius());
      const double        depth =
        std::max(0.7 * here,
                 tip.radius() - (tip.radius() - here) / cos_degrees(tip.turn));
      const Point<2> corner =
        tip.end + depth / tip.radius() * (tip.center - tip.end);

      // Behind the flank the line goes on to the layer of the first fillet.
      const Tensor<1, 2> line =
        inner_point(profile[4], true, thickness, 0.) - corner;
      const double chord = tip.start.distance(tip.end);
      const double up    = std::max(tip.start[1] - corner[1], 0.7 * chord);
      const double along =
        std::max((profile[3].start - corner) * line / line.norm(), 0.7 * chord);
      return {on_rim(profile[0].start[0] + here),
              Point<2>(tip.start[0] + here, corner[1] + up),
              corner,
              corner + along / line.norm() * line};
    }



    std::vector<Point<2>>
    DiscLayer::inner_points() const
    {
      const double tip_layer =
        joint.n_teeth == 1 ?
          0. :
          layer_at_tip(joint, profile[6].radius(), thickness);
      const double lean = lean_at_tip(joint);

      std::vector<Point<2>> inner = inner_points_of_first_tooth();
      for (unsigned int v = inner.size(); v < profile.size(); ++v)
        {
          const Kind kind = profile[v].kind;
          inner.push_back(kind == Kind::fillet || kind == Kind::contact ?
                            inner_point(profile[v],
                                        true,
                                        tip_layer,
                                        kind == Kind::fillet ? -lean : lean) :
                            inner_point(profile[v], true, thickness, 0.));
        }
      inner.push_back(profile.back().end - Tensor<1, 2>({0., thickness}));
      return inner;
    }



    FirTreeBand
    DiscLayer::band() const
    {
      const std::vector<Point<2>>     inner = inner_points();
      std::vector<FirTreeBand::Piece> pieces;
      std::vector<Polyline>           across;
      for (const ProfilePiece &piece : profile)
        {
          pieces.push_back(
            {piece,
             fractions(piece),
             piece.kind == Kind::tip || piece.kind == Kind::bottom});
          across.push_back(straight_line(piece.start,
                                         inner[across.size()],
                                         equal_fractions(cells.n_layer)));
        }
      across.front() = arc(profile.front().start,
                           inner.front(),
                           Point<2>(),
                           equal_fractions(cells.n_layer));
      across.push_back(straight_line(profile.back().end,
                                     inner.back(),
                                     equal_fractions(cells.n_layer)));
      return FirTreeBand(pieces, across);
    }
  } // namespace



  FirTreeLayer
  disc_sector_layer(const FirTreeJoint &joint,
                    const FirTreeCells &cells,
                    const double        bore_radius)
  {
    const DiscLayer layer(joint, cells, bore_radius);
    return {layer.profile, layer.thickness, layer.band()};
  }
} // namespace Signorini
