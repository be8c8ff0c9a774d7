#include <signorini/geometry/degrees.h>
#include <signorini/geometry/fir_tree/fir_tree_band.h>

#include <algorithm>

namespace Signorini
{
  using namespace dealii;

  using Kind = ProfilePiece::Kind;

  FirTreeBand::FirTreeBand(const std::vector<Piece>    &pieces,
                           const std::vector<Polyline> &across)
    : pieces(pieces)
    , across_lines(across)
  {
    AssertDimension(across.size(), pieces.size() + 1);
    for (unsigned int i = 0; i < pieces.size(); ++i)
      {
        const auto &[profile, fractions, is_round] = pieces[i];
        outer_lines.emplace_back();
        for (const double fraction : fractions)
          outer_lines.back().push_back(profile.at(fraction));
        const Point<2> begin = across[i].back(), end = across[i + 1].back();
        inner_lines.push_back(is_round ?
                                arc(begin, end, profile.center, fractions) :
                                straight_line(begin, end, fractions));
      }
  }



  const Polyline &
  FirTreeBand::inner(const unsigned int piece) const
  {
    return inner_lines[piece];
  }



  const Polyline &
  FirTreeBand::across(const unsigned int vertex) const
  {
    return across_lines[vertex];
  }



  void
  FirTreeBand::add_to(Patchwork &patchwork, const bool contact_has_arcs) const
  {
    for (unsigned int i = 0; i < pieces.size(); ++i)
      {
        const ProfilePiece &profile = pieces[i].profile;
        patchwork.add({outer_lines[i],
                       inner_lines[i],
                       across_lines[i],
                       across_lines[i + 1],
                       pieces[i].is_round,
                       profile.center});
        const bool is_contact =
          profile.kind == Kind::contact ||
          (contact_has_arcs &&
           (profile.kind == Kind::fillet || profile.kind == Kind::tip));
        patchwork.mark_boundary(outer_lines[i],
                                is_contact ?
                                  FirTreeBoundary::first + profile.tooth - 1 :
                                  FirTreeBoundary::free);
        if (profile.is_arc())
          patchwork.mark_arc(outer_lines[i], profile.center);
      }
  }



  Polyline
  FirTreeBand::add_tooth_to(Patchwork &patchwork, const unsigned int tip) const
  {
    const Polyline &before = inner_lines[tip - 1];
    const Polyline &after  = inner_lines[tip + 1];
    const Polyline  base =
      straight_line(before.front(), after.back(), pieces[tip].fractions);
    patchwork.add({before, reversed(after), base, inner_lines[tip]});
    return base;
  }



  Point<2>
  FirTreeSpine::foot(const Point<2> &p, const double shift) const
  {
    return Point<2>((p * direction + shift) * direction);
  }



  Polyline
  line_to_spine(const Point<2>    &start,
                const Point<2>    &end,
                const double       direction,
                const double       reach,
                const double       first_size,
                const unsigned int n_cells)
  {
    const double   length = start.distance(end);
    const Point<2> control =
      start + std::min(reach, 0.25 * length) *
                Tensor<1, 2>({cos_degrees(direction), sin_degrees(direction)});
    return parabola(start,
                    control,
                    end,
                    growing_fractions(n_cells, first_size / length));
  }



  void
  name_fir_tree_boundaries(const FirTreeJoint &joint,
                           const bool          is_full,
                           const std::string  &end_name,
                           Mesh<2>            &mesh)
  {
    mesh.boundaries = {{"free", FirTreeBoundary::free},
                       {end_name, FirTreeBoundary::end}};
    if (!is_full)
      mesh.boundaries["symmetry"] = FirTreeBoundary::symmetry;
    for (unsigned int tooth = 0; tooth < joint.n_teeth; ++tooth)
      {
        const std::string name = "contact_" + std::to_string(tooth + 1);
        mesh.boundaries[name + (is_full ? "_right" : "")] =
          FirTreeBoundary::first + tooth;
        if (is_full)
          mesh.boundaries[name + "_left"] = FirTreeBoundary::first_left + tooth;
      }
  }



  void
  mirror_fir_tree(Patchwork &patchwork)
  {
    patchwork.mirror(FirTreeBoundary::symmetry,
                     [](const types::boundary_id id) -> types::boundary_id {
                       if (id >= FirTreeBoundary::first)
                         return id - FirTreeBoundary::first +
                                FirTreeBoundary::first_left;
                       return id == FirTreeBoundary::side ?
                                FirTreeBoundary::side_left :
                                id;
                     });
  }
} // namespace Signorini
