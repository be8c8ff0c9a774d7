#ifndef tests_unit_mesh_measures_h
#define tests_unit_mesh_measures_h

#include <signorini/geometry/mesh.h>
#include <signorini/geometry/mesh_generator.h>
#include <signorini/input/input_error.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_nothing.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/grid/tria.h>

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <set>
#include <string>

#include "contains.h"

/** The mesh that a body's section with these lines describes. */
template <int dim>
Signorini::Mesh<dim>
mesh_from(const std::string &lines,
          const std::string &base_directory = "",
          const std::string &formulation    = "")
{
  dealii::ParameterHandler prm;
  Signorini::declare_mesh_parameters<dim>(prm);
  prm.parse_input_from_string(lines);
  return Signorini::create_mesh<dim>(prm, base_directory, formulation);
}

/** The message for such lines, or nothing when they make a mesh. */
template <int dim>
std::string
error_from(const std::string &lines,
           const std::string &base_directory = "",
           const std::string &formulation    = "")
{
  try
    {
      mesh_from<dim>(lines, base_directory, formulation);
    }
  catch (const Signorini::InputError &error)
    {
      return error.what();
    }
  return "";
}

/** Area or volume of the cells with straight edges. */
template <int dim>
double
volume(const Signorini::Mesh<dim> &mesh)
{
  double sum = 0.;
  for (const auto &cell : mesh.triangulation->active_cell_iterators())
    sum += cell->measure();
  return sum;
}

/** What the outward normals n of a boundary add up to. */
template <int dim>
struct BoundaryMeasures
{
  double                 area = 0.;    // integral of 1
  dealii::Tensor<1, dim> normal;       // integral of n
  double                 flux    = 0.; // integral of x . n
  unsigned int           n_faces = 0;
};

template <int dim>
BoundaryMeasures<dim>
measure(const Signorini::Mesh<dim> &mesh, const std::string &name)
{
  const auto                    id = mesh.boundary(name);
  const dealii::FE_Nothing<dim> element;
  dealii::FEFaceValues<dim>     values(element,
                                   dealii::QGauss<dim - 1>(3),
                                   dealii::update_JxW_values |
                                     dealii::update_normal_vectors |
                                     dealii::update_quadrature_points);
  BoundaryMeasures<dim>         sum;
  for (const auto &cell : mesh.triangulation->active_cell_iterators())
    for (const unsigned int f : cell->face_indices())
      if (cell->face(f)->at_boundary() && cell->face(f)->boundary_id() == id)
        {
          ++sum.n_faces;
          values.reinit(cell, f);
          for (unsigned int q = 0; q < values.n_quadrature_points; ++q)
            {
              sum.area += values.JxW(q);
              sum.normal += values.JxW(q) * values.normal_vector(q);
              sum.flux += values.JxW(q) * (values.normal_vector(q) *
                                           values.quadrature_point(q));
            }
        }
  return sum;
}

/**
 * The named boundaries are closed and enclose the volume: by Gauss's theorem
 * the integral of n is 0 and that of x . n is dim times the volume. Returns
 * the larger of both errors, relative to surface and volume.
 */
template <int dim>
double
error_of_enclosure(const Signorini::Mesh<dim> &mesh)
{
  dealii::Tensor<1, dim>               normal;
  double                               area = 0., flux = 0.;
  std::set<dealii::types::boundary_id> done;
  for (const auto &[name, id] : mesh.boundaries)
    if (done.insert(id).second)
      {
        const BoundaryMeasures<dim> part = measure(mesh, name);
        normal += part.normal;
        area += part.area;
        flux += part.flux;
      }
  const double v = volume(mesh);
  return std::max(normal.norm() / area, std::abs(flux - dim * v) / (dim * v));
}

/** The names in alphabetical order, with commas. */
template <typename Id>
std::string
names_of(const std::map<std::string, Id> &names)
{
  std::string list;
  for (const auto &entry : names)
    list += (list.empty() ? "" : ",") + entry.first;
  return list;
}

/** Checks size and outward normal of a flat boundary, to rounding errors. */
template <int dim>
void
check_flat(const Signorini::Mesh<dim>   &mesh,
           const std::string            &name,
           const double                  area,
           const dealii::Tensor<1, dim> &normal)
{
  const BoundaryMeasures<dim> found = measure(mesh, name);
  BOOST_TEST_CONTEXT(name)
  {
    BOOST_TEST(std::abs(found.area - area) <= 1e-13 * area);
    BOOST_TEST((found.normal - area * normal).norm() <= 1e-13 * area);
  }
}

/** The lines with n global refinements. */
inline std::string
refined(const std::string &lines, const unsigned int n)
{
  return lines + "set Global refinements = " + std::to_string(n) + "\n";
}

#endif
