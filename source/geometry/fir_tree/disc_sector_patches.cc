#include <signorini/geometry/degrees.h>
#include <signorini/geometry/fir_tree/disc_sector_patches.h>
#include <signorini/geometry/fir_tree/fir_tree_layer.h>

#include <algorithm>
#include <cmath>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    const Point<2> axis_of_disc;

    // The pieces are numbered as in disc_sector_layer(), and the vertices as
    // the pieces that begin there.
    class DiscMesh
    {
    public:
      DiscMesh(const FirTreeJoint &joint,
               const FirTreeCells &cells,
               const FirTreeLayer &layer,
               const double        bore_radius,
               const unsigned int  n_bore);

      Patchwork
      patches() const;

    private:
      const FirTreeJoint &joint;
      const FirTreeCells &cells;
      const FirTreeLayer &layer;
      const double        bore_radius;
      const unsigned int  n_bore;
      const FirTreeSpine  spine;

      Polyline
      line_to_side(const Point<2> &start, const unsigned int vertex) const;

      Polyline
      line_to_bore(const Point<2> &start) const;

      void
      add_first_tooth(const Polyline &below, Patchwork &patchwork) const;

      void
      add_to_bore(const Polyline &surface,
                  const Polyline &begin,
                  const Polyline &end,
                  Patchwork      &patchwork) const;

      void
      add_below_slot(const Polyline &above, Patchwork &patchwork) const;
    };



    DiscMesh::DiscMesh(const FirTreeJoint &joint,
                       const FirTreeCells &cells,
                       const FirTreeLayer &layer,
                       const double        bore_radius,
                       const unsigned int  n_bore)
      : joint(joint)
      , cells(cells)
      , layer(layer)
      , bore_radius(bore_radius)
      , n_bore(n_bore)
      , spine{Tensor<1, 2>({sin_degrees(180. / joint.n_blades),
                            cos_degrees(180. / joint.n_blades)})}
    {}



    // From the ends of a fillet the lines draw away from each other.
    Polyline
    DiscMesh::line_to_side(const Point<2>    &start,
                           const unsigned int vertex) const
    {
      const std::vector<ProfilePiece> &profile  = layer.profile;
      const bool                       is_above = vertex % 4 == 0;
      const unsigned int               first = is_above ? vertex - 3 : vertex;
      const bool has_base = first > 1 && first + 3 < profile.size();
      // Beside the rim and below the slot there is room.
      const double base =
        has_base ? profile[first].start.distance(profile[first + 3].start) :
                   profile[4].start.distance(profile[4].end);
      const double shift =
        std::min(0.15 * base, 0.3 * start.distance(spine.foot(start)));
      return line_to_spine(start,
                           spine.foot(start, is_above ? shift : -shift),
                           is_above ? 60. - joint.contact_angle :
                                      joint.back_angle - 60.,
                           0.3 * base,
                           layer.thickness / cells.n_layer,
                           cells.n_core);
    }



    Polyline
    DiscMesh::line_to_bore(const Point<2> &start) const
    {
      const Point<2> end(bore_radius / start.norm() * start);
      return straight_line(start,
                           end,
                           growing_fractions(n_bore,
                                             layer.thickness / cells.n_layer /
                                               start.distance(end)));
    }



    void
    DiscMesh::add_first_tooth(const Polyline &below, Patchwork &patchwork) const
    {
      const FirTreeBand &band  = layer.band;
      const Polyline     left  = reversed(joined(band.inner(0), band.inner(1)));
      const Polyline     flank = joined(band.inner(2), band.inner(3));
      const Point<2>     end_of_rim(joint.rim_radius * spine.direction);
      const double       x = flank.back()[0];
      const Point<2>     above_flank(x,
                                 std::sqrt(joint.rim_radius * joint.rim_radius -
                                           x * x));
      const Polyline     middle =
        straight_line(flank.back(), above_flank, positions_along(left));
      const Polyline first_rim =
        arc(left.back(), above_flank, axis_of_disc, positions_along(flank));
      const Polyline second_rim =
        arc(above_flank, end_of_rim, axis_of_disc, positions_along(below));
      const Polyline side =
        straight_line(below.back(), end_of_rim, positions_along(middle));

      patchwork.add({flank, first_rim, left, middle});
      patchwork.add({below, second_rim, middle, side});
      patchwork.mark_boundary(side, FirTreeBoundary::side);
      for (const Polyline &rim : {band.across(0), first_rim, second_rim})
        {
          patchwork.mark_boundary(rim, FirTreeBoundary::free);
          patchwork.mark_arc(rim, axis_of_disc);
        }
    }



    void
    DiscMesh::add_to_bore(const Polyline &surface,
                          const Polyline &begin,
                          const Polyline &end,
                          Patchwork      &patchwork) const
    {
      const Polyline bore =
        arc(begin.back(), end.back(), axis_of_disc, positions_along(surface));
      patchwork.add({surface, bore, begin, end});
      patchwork.mark_boundary(bore, FirTreeBoundary::end);
      patchwork.mark_arc(bore, axis_of_disc);
    }



    void
    DiscMesh::add_below_slot(const Polyline &above, Patchwork &patchwork) const
    {
      const FirTreeBand &band     = layer.band;
      const unsigned int n_pieces = layer.profile.size();
      const Polyline    &back     = band.inner(n_pieces - 2);
      const Polyline    &bottom   = band.inner(n_pieces - 1);
      const Polyline     first    = line_to_bore(back.front());
      const Polyline     second   = line_to_bore(back.back());
      const Polyline     third    = line_to_bore(bottom.back());
      const Polyline     side =
        straight_line(above.back(),
                      Point<2>(bore_radius * spine.direction),
                      positions_along(first));
      add_to_bore(above, first, side, patchwork);
      add_to_bore(back, first, second, patchwork);
      add_to_bore(bottom, second, third, patchwork);
      patchwork.mark_boundary(side, FirTreeBoundary::side);
      patchwork.mark_boundary(third, FirTreeBoundary::symmetry);
      patchwork.mark_boundary(band.across(n_pieces), FirTreeBoundary::symmetry);
    }



    Patchwork
    DiscMesh::patches() const
    {
      Patchwork          patchwork;
      const FirTreeBand &band     = layer.band;
      const unsigned int n_pieces = layer.profile.size();
      band.add_to(patchwork, cells.contact_has_arcs);

      Polyline above = line_to_side(band.inner(4).front(), 4);
      add_first_tooth(above, patchwork);
      for (unsigned int v = 4; v + 2 < n_pieces; v += 4)
        {
          const Polyline &fillet = band.inner(v);
          const Polyline  below  = line_to_side(fillet.back(), v + 1);
          patchwork.add_to_boundary(fillet,
                                    above,
                                    below,
                                    FirTreeBoundary::side);
          above = below;
          if (v + 4 < n_pieces)
            {
              const Polyline base = band.add_tooth_to(patchwork, v + 2);
              const Polyline end  = line_to_side(base.back(), v + 4);
              patchwork.add_to_boundary(base,
                                        below,
                                        end,
                                        FirTreeBoundary::side);
              above = end;
            }
        }
      add_below_slot(above, patchwork);
      return patchwork;
    }
  } // namespace



  Patchwork
  disc_sector_patches(const FirTreeJoint &joint,
                      const FirTreeCells &cells,
                      const double        bore_radius,
                      const unsigned int  n_bore)
  {
    const FirTreeLayer layer = disc_sector_layer(joint, cells, bore_radius);
    return DiscMesh(joint, cells, layer, bore_radius, n_bore).patches();
  }
} // namespace Signorini
