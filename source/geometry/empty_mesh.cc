#include <signorini/geometry/empty_mesh.h>
#include <signorini/input/instantiate.h>

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

#define INSTANTIATE(dim) template Mesh<dim> empty_mesh<dim>();
  SIGNORINI_FOR_EACH_DIMENSION(INSTANTIATE)
#undef INSTANTIATE
} // namespace Signorini
