#include <signorini/geometry/empty_mesh.h>

namespace Signorini
{
  using namespace dealii;

  template <int dim>
  Mesh<dim>
  empty_mesh()
  {
    Mesh<dim> mesh;
    mesh.triangulation = std::make_unique<Triangulation<dim>>(
      Triangulation<dim>::limit_level_difference_at_vertices,
      /*check_for_distorted_cells=*/true);
    mesh.regions["body"] = 0;
    return mesh;
  }

  template Mesh<2>
  empty_mesh<2>();
  template Mesh<3>
  empty_mesh<3>();
} // namespace Signorini
