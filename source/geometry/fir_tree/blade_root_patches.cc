#include <signorini/geometry/fir_tree/blade_root_patches.h>
#include <signorini/geometry/fir_tree/fir_tree_layer.h>

#include <algorithm>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    // The pieces are numbered as in blade_root_layer().
    class BladeMesh
    {
    public:
      BladeMesh(const FirTreeJoint &joint,
                const FirTreeCells &cells,
                const FirTreeLayer &layer)
        : joint(joint)
        , cells(cells)
        , layer(layer)
      {}

      Patchwork
      patches() const;

    private:
      const FirTreeJoint &joint;
      const FirTreeCells &cells;
      const FirTreeLayer &layer;
      const FirTreeSpine  spine = {Tensor<1, 2>({0., 1.})};

      double
      base_height(const unsigned int tooth) const;

      Polyline
      floor() const;

      Polyline
      line_to_middle(const Point<2>    &start,
                     const unsigned int tooth,
                     const bool         is_upper) const;

      void
      add_shank(const Polyline &below, Patchwork &patchwork) const;
    };



    // Between the working flank's inner end and that of the back flank.
    double
    BladeMesh::base_height(const unsigned int tooth) const
    {
      return layer.profile[4 * tooth + 2].start.distance(
        layer.profile[4 * tooth + 4].end);
    }



    // The lines from the two ends of a tooth's base come nearer to each other.
    Polyline
    BladeMesh::line_to_middle(const Point<2>    &start,
                              const unsigned int tooth,
                              const bool         is_upper) const
    {
      const double base  = base_height(tooth);
      const double shift = std::min(0.15 * base, 0.3 * start[0]);
      return line_to_spine(start,
                           spine.foot(start, is_upper ? -shift : shift),
                           is_upper ? 240. - joint.contact_angle :
                                      120. + joint.back_angle,
                           0.3 * base,
                           layer.thickness / cells.n_layer,
                           cells.n_core);
    }



    void
    BladeMesh::add_shank(const Polyline &below, Patchwork &patchwork) const
    {
      const Polyline &surface = layer.band.inner(0);
      const Polyline  top     = straight_line(surface.front(),
                                         spine.foot(surface.front()),
                                         positions_along(below));
      patchwork.add_to_boundary(surface, top, below, FirTreeBoundary::symmetry);
      patchwork.mark_boundary(top, FirTreeBoundary::end);
      patchwork.mark_boundary(layer.band.across(0), FirTreeBoundary::end);
    }



    Polyline
    BladeMesh::floor() const
    {
      const unsigned int n_pieces = layer.profile.size();
      const Polyline    &last     = layer.band.inner(n_pieces - 1);
      return n_pieces == 4 * joint.n_teeth + 2 ?
               last :
               joined(layer.band.inner(n_pieces - 2), last);
    }



    Patchwork
    BladeMesh::patches() const
    {
      Patchwork          patchwork;
      const FirTreeBand &band = layer.band;
      band.add_to(patchwork, cells.contact_has_arcs);

      const Point<2> start = band.inner(1).front();
      Polyline       above = line_to_spine(start,
                                     spine.foot(start),
                                     180.,
                                     0.,
                                     layer.thickness / cells.n_layer,
                                     cells.n_core);
      add_shank(above, patchwork);
      for (unsigned int tooth = 0; tooth < joint.n_teeth; ++tooth)
        {
          const Polyline &fillet = band.inner(4 * tooth + 1);
          const Polyline  upper  = line_to_middle(fillet.back(), tooth, true);
          patchwork.add_to_boundary(fillet,
                                    above,
                                    upper,
                                    FirTreeBoundary::symmetry);

          const Polyline base  = band.add_tooth_to(patchwork, 4 * tooth + 3);
          const Polyline lower = tooth + 1 == joint.n_teeth ?
                                   floor() :
                                   line_to_middle(base.back(), tooth, false);
          patchwork.add_to_boundary(base,
                                    upper,
                                    lower,
                                    FirTreeBoundary::symmetry);
          above = lower;
        }
      patchwork.mark_boundary(band.across(layer.profile.size()),
                              FirTreeBoundary::symmetry);
      return patchwork;
    }
  } // namespace



  Patchwork
  blade_root_patches(const FirTreeJoint &joint,
                     const FirTreeCells &cells,
                     const double        shank_height,
                     const unsigned int  n_shank)
  {
    const FirTreeLayer layer =
      blade_root_layer(joint, cells, shank_height, n_shank);
    return BladeMesh(joint, cells, layer).patches();
  }
} // namespace Signorini
