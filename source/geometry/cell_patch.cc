#include <signorini/geometry/cell_patch.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    Point<2>
    vertex(const CellPatch &patch, const unsigned int i, const unsigned int j)
    {
      const unsigned int n = patch.bottom.size() - 1;
      const unsigned int m = patch.left.size() - 1;
      if (j == 0 || j == m)
        return (j == 0 ? patch.bottom : patch.top)[i];
      if (i == 0 || i == n)
        return (i == 0 ? patch.left : patch.right)[j];
      const double x = i / double(n), y = j / double(m);
      return Point<2>((1. - y) * patch.bottom[i] + y * patch.top[i] +
                      (1. - x) * patch.left[j] + x * patch.right[j] -
                      (1. - x) * (1. - y) * patch.bottom[0] -
                      x * (1. - y) * patch.bottom[n] -
                      (1. - x) * y * patch.top[0] - x * y * patch.top[n]);
    }
  } // namespace



  std::vector<Point<2>>
  divide(const unsigned int n, const std::function<Point<2>(double)> &curve)
  {
    std::vector<Point<2>> points;
    for (unsigned int i = 0; i <= n; ++i)
      points.push_back(curve(i / double(n)));
    return points;
  }



  std::vector<Point<2>>
  divide_line(const unsigned int n, const Point<2> &begin, const Point<2> &end)
  {
    return divide(n, [&](const double s) {
      return Point<2>((1. - s) * begin + s * end);
    });
  }



  CellPatch
  mirrored(const CellPatch &patch)
  {
    CellPatch result = {mirrored(patch.bottom),
                        mirrored(patch.top),
                        mirrored(patch.right),
                        mirrored(patch.left)};
    std::reverse(result.bottom.begin(), result.bottom.end());
    std::reverse(result.top.begin(), result.top.end());
    return result;
  }



  void
  add_patch(const CellPatch &patch, CellCollection &collection)
  {
    AssertDimension(patch.bottom.size(), patch.top.size());
    AssertDimension(patch.left.size(), patch.right.size());
    const unsigned int n     = patch.bottom.size();
    const unsigned int m     = patch.left.size();
    const unsigned int first = collection.vertices.size();
    for (unsigned int j = 0; j < m; ++j)
      for (unsigned int i = 0; i < n; ++i)
        collection.vertices.push_back(vertex(patch, i, j));
    for (unsigned int j = 0; j + 1 < m; ++j)
      for (unsigned int i = 0; i + 1 < n; ++i)
        {
          const unsigned int here = first + j * n + i;
          CellData<2>        cell;
          cell.vertices    = {here, here + 1, here + n, here + n + 1};
          cell.material_id = 0;
          collection.cells.push_back(cell);
        }
  }



  void
  add_lines(const std::vector<Point<2>> &points,
            const types::boundary_id     id,
            CellCollection              &collection)
  {
    const unsigned int first = collection.vertices.size();
    collection.vertices.insert(collection.vertices.end(),
                               points.begin(),
                               points.end());
    for (unsigned int i = 0; i + 1 < points.size(); ++i)
      {
        CellData<1> line;
        line.vertices    = {first + i, first + i + 1};
        line.boundary_id = id;
        collection.lines.push_back(line);
      }
  }
} // namespace Signorini
