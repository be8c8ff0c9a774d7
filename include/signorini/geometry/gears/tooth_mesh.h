#ifndef signorini_geometry_gears_tooth_mesh_h
#define signorini_geometry_gears_tooth_mesh_h

#include <signorini/geometry/gears/tooth_grid.h>
#include <signorini/geometry/mesh.h>

#include <string>

namespace Signorini
{
  /**
   * The mesh of a row of teeth. Boundaries: right_1, left_1, right_2, ... (the
   * flanks), tips, roots (with the fillets), the rim under the name @p
   * rim_name, and, unless the row is closed, start (before the first tooth)
   * and end. Region: body. New vertices of later refinements lie on the exact
   * profile, and on the circle of a bore.
   *
   * @param n_cells along a flank
   */
  Mesh<2>
  tooth_mesh(const HalfTooth   &tooth,
             const ToothRow    &row,
             const double       rim_height,
             const std::string &rim_name,
             const unsigned int n_cells);
} // namespace Signorini

#endif
