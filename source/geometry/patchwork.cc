#include <signorini/geometry/empty_mesh.h>
#include <signorini/geometry/patchwork.h>
#include <signorini/input/input_error.h>

#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/manifold_lib.h>

#include <algorithm>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    // Numbers points; equal ones get the same number.
    class Vertices
    {
    public:
      unsigned int
      number(const Point<2> &p)
      {
        const auto [entry, is_new] = numbers.insert(
          {{p[0], p[1]}, static_cast<unsigned int>(list.size())});
        if (is_new)
          list.push_back(p);
        return entry->second;
      }

      std::vector<Point<2>> list;

    private:
      std::map<std::pair<double, double>, unsigned int> numbers;
    };

    // The lines of the mesh that are not plain, by their two vertices.
    class Lines
    {
    public:
      CellData<1> &
      between(const unsigned int a, const unsigned int b)
      {
        const auto [entry, is_new] = lines.insert({std::minmax(a, b), {}});
        CellData<1> &line          = entry->second;
        if (is_new)
          {
            line.vertices    = {a, b};
            line.boundary_id = numbers::internal_face_boundary_id;
            line.manifold_id = numbers::flat_manifold_id;
          }
        return line;
      }

      std::vector<CellData<1>>
      list() const
      {
        std::vector<CellData<1>> result;
        for (const auto &entry : lines)
          result.push_back(entry.second);
        return result;
      }

    private:
      std::map<std::pair<unsigned int, unsigned int>, CellData<1>> lines;
    };

    // Inside, the mean of what the two pairs of edges propose (Coons).
    std::vector<Polyline>
    interpolate(const Patch &patch)
    {
      const unsigned int n = patch.bottom.size(), m = patch.left.size();
      AssertThrow(patch.top.size() == n && patch.right.size() == m &&
                    patch.bottom.front() == patch.left.front() &&
                    patch.bottom.back() == patch.right.front() &&
                    patch.top.front() == patch.left.back() &&
                    patch.top.back() == patch.right.back(),
                  ExcInternalError());
      const auto u_bottom = positions_along(patch.bottom);
      const auto u_top    = positions_along(patch.top);
      const auto v_left   = positions_along(patch.left);
      const auto v_right  = positions_along(patch.right);

      std::vector<Polyline> rows(m, Polyline(n));
      for (unsigned int j = 0; j < m; ++j)
        for (unsigned int i = 0; i < n; ++i)
          {
            const double s = 0.5 * (v_left[j] + v_right[j]);
            const double u = (1. - s) * u_bottom[i] + s * u_top[i];
            const double v = (1. - u) * v_left[j] + u * v_right[j];
            for (unsigned int d = 0; d < 2; ++d)
              rows[j][i][d] =
                (1. - v) * patch.bottom[i][d] + v * patch.top[i][d] +
                (1. - u) * patch.left[j][d] + u * patch.right[j][d] -
                (1. - v) * ((1. - u) * patch.bottom.front()[d] +
                            u * patch.bottom.back()[d]) -
                v * ((1. - u) * patch.top.front()[d] + u * patch.top.back()[d]);
          }
      rows.front() = patch.bottom;
      rows.back()  = patch.top;
      for (unsigned int j = 0; j < m; ++j)
        {
          rows[j].front() = patch.left[j];
          rows[j].back()  = patch.right[j];
        }
      return rows;
    }

    // Rows of a ring's part: equal fractions of the radii keep them concentric.
    std::vector<Polyline>
    rows_of(const Patch &patch)
    {
      std::vector<Polyline> rows = interpolate(patch);
      if (!patch.is_round)
        return rows;
      const std::vector<double> v = positions_along(patch.left);
      for (unsigned int j = 1; j + 1 < rows.size(); ++j)
        for (unsigned int i = 1; i + 1 < rows[j].size(); ++i)
          rows[j][i] =
            patch.bottom[i] + v[j] * (patch.top[i] - patch.bottom[i]);
      return rows;
    }

    // The manifold id of arcs about this point.
    types::manifold_id
    arcs_about(const Point<2> &center, std::vector<Point<2>> &centers)
    {
      const auto found = std::find(centers.begin(), centers.end(), center);
      const auto id    = found - centers.begin();
      if (found == centers.end())
        centers.push_back(center);
      return id;
    }

    void
    create_triangulation(const std::vector<Point<2>>    &vertices,
                         const std::vector<CellData<2>> &cells,
                         const std::vector<CellData<1>> &lines,
                         Triangulation<2>               &triangulation)
    {
      SubCellData marks;
      marks.boundary_lines = lines;
      try
        {
          triangulation.create_triangulation(vertices, cells, marks);
        }
      catch (const Triangulation<2>::DistortedCellList &)
        {
          throw InputError("The mesh has cells with a re-entrant corner: the "
                           "measures are too different for its blocks. Take "
                           "radii and lengths nearer to each other.");
        }
    }
  } // namespace



  void
  Patchwork::add(const Patch &patch)
  {
    patches.push_back(patch);
  }



  void
  Patchwork::add_to_boundary(const Polyline          &surface,
                             const Polyline          &above,
                             const Polyline          &below,
                             const types::boundary_id id)
  {
    const Polyline line =
      straight_line(above.back(), below.back(), positions_along(surface));
    add({surface, line, above, below});
    mark_boundary(line, id);
  }



  void
  Patchwork::mark_boundary(const Polyline &line, const types::boundary_id id)
  {
    boundaries.push_back({line, id});
  }



  void
  Patchwork::mark_arc(const Polyline &line, const Point<2> &center)
  {
    arcs.push_back({line, center});
  }



  void
  Patchwork::mirror(
    const types::boundary_id                                           seam,
    const std::function<types::boundary_id(const types::boundary_id)> &image)
  {
    boundaries.erase(std::remove_if(boundaries.begin(),
                                    boundaries.end(),
                                    [&](const MarkedBoundary &boundary) {
                                      return boundary.id == seam;
                                    }),
                     boundaries.end());
    const auto patches_here    = patches;
    const auto boundaries_here = boundaries;
    const auto arcs_here       = arcs;
    for (const Patch &patch : patches_here)
      patches.push_back({mirrored(patch.bottom),
                         mirrored(patch.top),
                         mirrored(patch.left),
                         mirrored(patch.right),
                         patch.is_round,
                         mirrored(patch.center)});
    for (const MarkedBoundary &boundary : boundaries_here)
      boundaries.push_back({mirrored(boundary.line), image(boundary.id)});
    for (const MarkedArc &arc : arcs_here)
      arcs.push_back({mirrored(arc.line), mirrored(arc.center)});
  }



  Mesh<2>
  Patchwork::create() const
  {
    Vertices                 vertices;
    Lines                    lines;
    std::vector<CellData<2>> cells;
    std::vector<Point<2>>    centers;

    const auto mark_arc_between = [&](const Polyline &line, const Point<2> &c) {
      for (unsigned int i = 1; i < line.size(); ++i)
        lines.between(vertices.number(line[i - 1]), vertices.number(line[i]))
          .manifold_id = arcs_about(c, centers);
    };

    for (const Patch &patch : patches)
      {
        const std::vector<Polyline> rows = rows_of(patch);
        for (unsigned int j = 1; j < rows.size(); ++j)
          for (unsigned int i = 1; i < rows[j].size(); ++i)
            {
              cells.emplace_back();
              cells.back().vertices    = {vertices.number(rows[j - 1][i - 1]),
                                          vertices.number(rows[j - 1][i]),
                                          vertices.number(rows[j][i - 1]),
                                          vertices.number(rows[j][i])};
              cells.back().material_id = 0;
              if (patch.is_round)
                cells.back().manifold_id = arcs_about(patch.center, centers);
            }
        if (patch.is_round)
          for (const Polyline &row : rows)
            mark_arc_between(row, patch.center);
      }
    for (const MarkedArc &arc : arcs)
      mark_arc_between(arc.line, arc.center);
    for (const auto &[line, id] : boundaries)
      for (unsigned int i = 1; i < line.size(); ++i)
        lines.between(vertices.number(line[i - 1]), vertices.number(line[i]))
          .boundary_id = id;

    GridTools::invert_cells_with_negative_measure(vertices.list, cells);
    GridTools::consistently_order_cells(cells);
    Mesh<2> mesh = empty_mesh<2>();
    create_triangulation(vertices.list,
                         cells,
                         lines.list(),
                         *mesh.triangulation);
    for (types::manifold_id id = 0; id < centers.size(); ++id)
      mesh.triangulation->set_manifold(id, SphericalManifold<2>(centers[id]));
    return mesh;
  }
} // namespace Signorini
