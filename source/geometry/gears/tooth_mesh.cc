#include <signorini/geometry/empty_mesh.h>
#include <signorini/geometry/gears/tooth_manifold.h>
#include <signorini/geometry/gears/tooth_mesh.h>
#include <signorini/input/input_error.h>

#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/manifold_lib.h>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    enum ManifoldId : types::manifold_id
    {
      on_profile,
      on_bore
    };

    // Ids of the names that teeth share; those of the flanks follow.
    enum BoundaryId : types::boundary_id
    {
      tips,
      roots,
      rim,
      start,
      end,
      first_flank
    };

    types::boundary_id
    flank_id(const unsigned int tooth, const bool is_right)
    {
      return first_flank + 2 * tooth + (is_right ? 0 : 1);
    }

    // Cuts between two teeth are inside.
    types::boundary_id
    boundary_id_of(const ToothSide    side,
                   const unsigned int tooth,
                   const ToothRow    &row)
    {
      switch (side)
        {
          case ToothSide::tip:
            return tips;
          case ToothSide::root:
            return roots;
          case ToothSide::rim:
            return rim;
          case ToothSide::right_flank:
            return flank_id(tooth, true);
          case ToothSide::left_flank:
            return flank_id(tooth, false);
          default:
            break;
        }
      // The teeth of a rack go to the right, those of a gear to the left.
      const bool is_next  = (side == ToothSide::right_cut) != row.is_round;
      const bool is_outer = tooth == (is_next ? row.n_teeth - 1 : 0);
      if (row.is_closed() || !is_outer)
        return numbers::internal_face_boundary_id;
      return is_next ? end : start;
    }

    types::manifold_id
    manifold_id_of(const types::boundary_id id, const ToothRow &row)
    {
      if (id == rim)
        return row.is_round ? types::manifold_id(on_bore) :
                              numbers::flat_manifold_id;
      return id == start || id == end ? numbers::flat_manifold_id :
                                        types::manifold_id(on_profile);
    }

    std::map<std::string, types::boundary_id>
    boundary_names(const ToothRow &row, const std::string &rim_name)
    {
      std::map<std::string, types::boundary_id> names = {{"tips", tips},
                                                         {"roots", roots},
                                                         {rim_name, rim}};
      if (!row.is_closed())
        names.insert({{"start", start}, {"end", end}});
      for (unsigned int tooth = 0; tooth < row.n_teeth; ++tooth)
        for (const bool is_right : {true, false})
          names[(is_right ? "right_" : "left_") + std::to_string(tooth + 1)] =
            flank_id(tooth, is_right);
      return names;
    }

    // Adds the cells and the named lines of one tooth.
    void
    add_tooth(const CellCollection     &grid,
              const ToothRow           &row,
              const unsigned int        tooth,
              std::vector<Point<2>>    &vertices,
              std::vector<CellData<2>> &cells,
              SubCellData              &boundary)
    {
      const unsigned int first = vertices.size();
      for (const Point<2> &p : grid.vertices)
        vertices.push_back(row.place({int(tooth), p}));
      for (CellData<2> cell : grid.cells)
        {
          for (unsigned int &vertex : cell.vertices)
            vertex += first;
          cells.push_back(cell);
        }
      for (CellData<1> line : grid.lines)
        {
          for (unsigned int &vertex : line.vertices)
            vertex += first;
          line.boundary_id =
            boundary_id_of(static_cast<ToothSide>(line.boundary_id),
                           tooth,
                           row);
          if (line.boundary_id == numbers::internal_face_boundary_id)
            continue;
          line.manifold_id = manifold_id_of(line.boundary_id, row);
          boundary.boundary_lines.push_back(line);
        }
    }
  } // namespace



  Mesh<2>
  tooth_mesh(const HalfTooth   &tooth,
             const ToothRow    &row,
             const double       rim_height,
             const std::string &rim_name,
             const unsigned int n_cells)
  {
    const CellCollection grid = tooth_grid(tooth, row, rim_height, n_cells);
    if (double(grid.cells.size()) * row.n_teeth > maximal_n_cells)
      throw InputError(
        "The teeth get more than 20 million cells. Ask for fewer "
        "with Cells along a flank.");

    std::vector<Point<2>>    vertices;
    std::vector<CellData<2>> cells;
    SubCellData              boundary;
    for (unsigned int i = 0; i < row.n_teeth; ++i)
      add_tooth(grid, row, i, vertices, cells, boundary);

    // Vertices on the sides of blocks were made once for each block.
    std::vector<unsigned int> considered;
    GridTools::delete_duplicated_vertices(
      vertices, cells, boundary, considered, 1e-8 * tooth.profile.length());
    GridTools::consistently_order_cells(cells);

    Mesh<2> mesh = empty_mesh<2>();
    mesh.triangulation->set_manifold(
      on_profile, ToothManifold(RowProfile(row, tooth.profile)));
    if (row.is_round)
      mesh.triangulation->set_manifold(on_bore,
                                       SphericalManifold<2>(row.origin));
    mesh.triangulation->create_triangulation(vertices, cells, boundary);
    mesh.boundaries = boundary_names(row, rim_name);
    return mesh;
  }
} // namespace Signorini
