#ifndef tests_unit_fir_tree_measures_h
#define tests_unit_fir_tree_measures_h

#include <deal.II/fe/mapping_q.h>

#include <algorithm>
#include <string>

#include "mesh_measures.h"

inline std::string
blade_lines(const std::string &lines)
{
  return "set Mesh = blade root\nsubsection Blade root\n" + lines + "end\n";
}

inline std::string
disc_lines(const std::string &lines)
{
  return "set Mesh = disc sector\nsubsection Disc sector\n" + lines + "end\n";
}

// The smallest Jacobian of the bilinear cells over its mean in the cell.
inline double
worst_jacobian(const Signorini::Mesh<2> &mesh)
{
  double smallest = 1.;
  for (const auto &cell : mesh.triangulation->active_cell_iterators())
    for (const unsigned int v : cell->vertex_indices())
      {
        const dealii::Tensor<1, 2> a =
          cell->vertex(v | 1u) - cell->vertex(v & ~1u);
        const dealii::Tensor<1, 2> b =
          cell->vertex(v | 2u) - cell->vertex(v & ~2u);
        smallest =
          std::min(smallest, (a[0] * b[1] - a[1] * b[0]) / cell->measure());
      }
  return smallest;
}

// The smallest Jacobian of curved cells of degree 2, over the largest one of
// the cell.
inline double
worst_curved_jacobian(const Signorini::Mesh<2> &mesh)
{
  const dealii::FE_Nothing<2> element;
  const dealii::MappingQ<2>   mapping(2);
  dealii::FEValues<2>         values(mapping,
                             element,
                             dealii::QGaussLobatto<2>(4),
                             dealii::update_jacobians);
  double                      smallest = 1.;
  for (const auto &cell : mesh.triangulation->active_cell_iterators())
    {
      values.reinit(cell);
      double largest = 0., least = 1.;
      for (unsigned int q = 0; q < values.n_quadrature_points; ++q)
        {
          const double jacobian = values.jacobian(q).determinant();
          largest               = std::max(largest, jacobian);
          least                 = std::min(least, jacobian);
        }
      smallest = std::min(smallest, least / largest);
    }
  return smallest;
}

// One piece without holes: vertices - lines + cells = 1. Patches that should
// have been sewn together leave a slit or a hole.
inline int
euler_number(const Signorini::Mesh<2> &mesh)
{
  const auto &triangulation = *mesh.triangulation;
  return static_cast<int>(triangulation.n_used_vertices() +
                          triangulation.n_active_cells()) -
         static_cast<int>(triangulation.n_active_lines());
}

#endif
