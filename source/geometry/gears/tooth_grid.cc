#include <signorini/geometry/gears/tooth_grid.h>
#include <signorini/geometry/shapes/block.h>

#include <algorithm>
#include <cmath>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    using Points = std::vector<Point<2>>;

    /** Adds the patches of one tooth, with letters as in tooth_grid.h. */
    class ToothPatches
    {
    public:
      ToothPatches(const HalfTooth   &tooth,
                   const ToothRow    &row,
                   const double       rim_height,
                   const unsigned int n_cells);

      void
      add_tooth(CellCollection &grid) const;

      void
      add_roots(CellCollection &grid) const;

      void
      add_rim(CellCollection &grid) const;

    private:
      const HalfTooth &tooth;
      const ToothRow  &row;
      const double     rim_height;

      double cell_size, depth, layer_height, layer_side;

      // Numbers of cells.
      unsigned int n_across, n_flank, n_foot, n_root, n_depth;

      Points
      along_profile(const unsigned int n,
                    const double       from,
                    const double       to) const;

      Points
      along_layer(const unsigned int n,
                  const double       from,
                  const double       to,
                  const double       height) const;

      // From P to K.
      Points
      bisector() const;

      // The tip, all of it, from the left to the right.
      Points
      tip() const;

      // The part of the rim between two values of ToothRow::side_of().
      void
      add_rim_part(const double       from,
                   const double       to,
                   const unsigned int n,
                   CellCollection    &grid) const;

      std::vector<double>
      rim_heights() const;
    };



    unsigned int
    at_least(const unsigned int minimum, const double n)
    {
      return std::max(minimum, static_cast<unsigned int>(std::lround(n)));
    }



    void
    add_side(const Points &points, const ToothSide side, CellCollection &grid)
    {
      add_lines(points, static_cast<types::boundary_id>(side), grid);
    }



    ToothPatches::ToothPatches(const HalfTooth   &tooth,
                               const ToothRow    &row,
                               const double       rim_height,
                               const unsigned int n_cells)
      : tooth(tooth)
      , row(row)
      , rim_height(rim_height)
      , n_flank(n_cells)
    {
      const Point<2> R = tooth.profile.at(0.).position;
      const Point<2> K = tooth.profile.at(tooth.fillet_middle).position;
      const Point<2> J = tooth.profile.at(tooth.flank_begin).position;
      const Point<2> A = tooth.profile.at(tooth.flank_end).position;

      // P is closer to the axis than K, so that PK cuts the angle at K in two.
      const double root_height = row.height_of(R);
      depth        = std::min(0.7 * J[0], (root_height - rim_height) / 2.);
      layer_height = root_height - depth;
      layer_side   = 0.65 * row.side_of(K);

      cell_size = (tooth.flank_end - tooth.flank_begin) / n_cells;
      n_across  = at_least(2, (J[0] + A[0]) / cell_size);
      n_foot =
        at_least(1, (tooth.flank_begin - tooth.fillet_middle) / cell_size);
      n_root  = at_least(3, tooth.fillet_middle / cell_size);
      n_depth = at_least(2, depth / cell_size);
    }



    Points
    ToothPatches::along_profile(const unsigned int n,
                                const double       from,
                                const double       to) const
    {
      return divide(n, [&](const double s) {
        return tooth.profile.at((1. - s) * from + s * to).position;
      });
    }



    Points
    ToothPatches::along_layer(const unsigned int n,
                              const double       from,
                              const double       to,
                              const double       height) const
    {
      return divide(n, [&](const double s) {
        return row.local_point((1. - s) * from + s * to, height);
      });
    }



    Points
    ToothPatches::bisector() const
    {
      return divide_line(n_depth,
                         row.local_point(layer_side, layer_height),
                         tooth.profile.at(tooth.fillet_middle).position);
    }



    Points
    ToothPatches::tip() const
    {
      const double half = tooth.profile.length() - tooth.flank_end;
      return divide(n_across, [&](const double s) {
        const double from_corner = (1. - std::abs(2. * s - 1.)) * half;
        Point<2> p = tooth.profile.at(tooth.flank_end + from_corner).position;
        if (s < 0.5)
          p[0] *= -1.;
        return p;
      });
    }



    void
    ToothPatches::add_tooth(CellCollection &grid) const
    {
      const Points flank =
        along_profile(n_flank, tooth.flank_begin, tooth.flank_end);
      const Points foot =
        along_profile(n_foot, tooth.fillet_middle, tooth.flank_begin);
      const Points side = bisector();
      const Points neck =
        divide_line(n_across, mirrored(flank).front(), flank.front());
      const Points base =
        divide_line(n_across, mirrored(foot).front(), foot.front());

      add_patch({neck, tip(), mirrored(flank), flank}, grid);
      add_patch({base, neck, mirrored(foot), foot}, grid);
      add_patch({along_layer(n_across, -layer_side, layer_side, layer_height),
                 base,
                 mirrored(side),
                 side},
                grid);

      add_side(tip(), ToothSide::tip, grid);
      add_side(flank, ToothSide::right_flank, grid);
      add_side(mirrored(flank), ToothSide::left_flank, grid);
      add_side(foot, ToothSide::root, grid);
      add_side(mirrored(foot), ToothSide::root, grid);
    }



    void
    ToothPatches::add_roots(CellCollection &grid) const
    {
      const Points root = along_profile(n_root, tooth.fillet_middle, 0.);
      const Points cut =
        divide_line(n_depth, row.local_point(1., layer_height), root.back());
      const CellPatch right = {
        along_layer(n_root, layer_side, 1., layer_height),
        root,
        bisector(),
        cut};
      add_patch(right, grid);
      add_patch(mirrored(right), grid);

      add_side(root, ToothSide::root, grid);
      add_side(mirrored(root), ToothSide::root, grid);
      add_side(cut, ToothSide::right_cut, grid);
      add_side(mirrored(cut), ToothSide::left_cut, grid);
    }



    void
    ToothPatches::add_rim(CellCollection &grid) const
    {
      add_rim_part(-1., -layer_side, n_root, grid);
      add_rim_part(-layer_side, layer_side, n_across, grid);
      add_rim_part(layer_side, 1., n_root, grid);

      const auto cut = [&](const double side) {
        Points points;
        for (const double height : rim_heights())
          points.push_back(row.local_point(side, height));
        return points;
      };
      add_side(cut(-1.), ToothSide::left_cut, grid);
      add_side(cut(1.), ToothSide::right_cut, grid);
    }



    void
    ToothPatches::add_rim_part(const double       from,
                               const double       to,
                               const unsigned int n,
                               CellCollection    &grid) const
    {
      // One row of cells after the other: arcs stay arcs.
      const std::vector<double> heights = rim_heights();
      for (unsigned int j = 0; j + 1 < heights.size(); ++j)
        {
          const Points below = along_layer(n, from, to, heights[j]);
          const Points above = along_layer(n, from, to, heights[j + 1]);
          add_patch({below,
                     above,
                     {below.front(), above.front()},
                     {below.back(), above.back()}},
                    grid);
        }
      add_side(along_layer(n, from, to, rim_height), ToothSide::rim, grid);
    }



    std::vector<double>
    ToothPatches::rim_heights() const
    {
      // Cells grow by this factor from the layer to the bore or back.
      const double       growth = 1.2;
      const double       height = layer_height - rim_height;
      const unsigned int n      = static_cast<unsigned int>(std::ceil(
        std::log1p(height / cell_size * (growth - 1.)) / std::log(growth)));
      return graded_points(rim_height,
                           layer_height,
                           n,
                           std::pow(growth, 1. - n));
    }
  } // namespace



  CellCollection
  tooth_grid(const HalfTooth   &tooth,
             const ToothRow    &row,
             const double       rim_height,
             const unsigned int n_cells)
  {
    const ToothPatches patches(tooth, row, rim_height, n_cells);
    CellCollection     grid;
    patches.add_tooth(grid);
    patches.add_roots(grid);
    patches.add_rim(grid);
    return grid;
  }
} // namespace Signorini
