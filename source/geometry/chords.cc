#include <signorini/geometry/chords.h>
#include <signorini/input/instantiate.h>

#include <deal.II/base/numbers.h>
#include <deal.II/grid/manifold.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include "outward_normal.h"

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    // Two vertices in 3-D, one in 2-D.
    using Joint = std::vector<unsigned int>;

    template <typename Face>
    std::vector<Joint>
    joints_of(const Face &face)
    {
      if (face->n_vertices() == 2)
        return {{face->vertex_index(0)}, {face->vertex_index(1)}};
      std::vector<Joint> joints;
      for (const auto &[a, b] :
           {std::pair(0, 1), std::pair(1, 3), std::pair(3, 2), std::pair(2, 0)})
        {
          joints.push_back({face->vertex_index(a), face->vertex_index(b)});
          std::sort(joints.back().begin(), joints.back().end());
        }
      return joints;
    }
  } // namespace



  template <int dim>
  Chords
  find_chords(const Mesh<dim>   &mesh,
              const std::string &boundary,
              const double       feature_angle)
  {
    const auto &triangulation = *mesh.triangulation;
    const auto  id            = mesh.boundary(boundary);
    Chords      chords;
    std::map<Joint, std::vector<Tensor<1, dim>>> normals;
    for (auto cell = triangulation.begin(0); cell != triangulation.end(0);
         ++cell)
      for (const auto &face : cell->face_iterators())
        {
          if (!face->at_boundary() || face->boundary_id() != id)
            continue;
          chords.are_cut = chords.are_cut || face->has_children();
          if (dynamic_cast<const FlatManifold<dim> *>(
                &triangulation.get_manifold(face->manifold_id())))
            for (const Joint &joint : joints_of(face))
              normals[joint].push_back(
                outward_normal<dim>(face, cell->center()));
        }
    unsigned int n_joints = 0, n_smooth = 0;
    for (const auto &[joint, of_faces] : normals)
      {
        if (of_faces.size() != 2)
          continue;
        ++n_joints;
        const double angle =
          std::acos(std::clamp(of_faces[0] * of_faces[1], -1., 1.)) * 180. /
          numbers::PI;
        if (angle < 0.5 || angle > feature_angle)
          continue;
        ++n_smooth;
        chords.turn = std::max(chords.turn, angle);
      }
    // In 3-D a cylinder is straight along its axis.
    if (n_smooth < 2 || n_smooth < n_joints / (dim == 3 ? 4 : 2))
      chords.turn = 0.;
    return chords;
  }



#define INSTANTIATE(dim)                           \
  template Chords find_chords(const Mesh<dim> &,   \
                              const std::string &, \
                              const double);
  SIGNORINI_FOR_EACH_DIMENSION(INSTANTIATE)
#undef INSTANTIATE
} // namespace Signorini
