#include <boost/test/unit_test.hpp>

#include "mesh_measures.h"

BOOST_AUTO_TEST_SUITE(round_meshes)

using dealii::Point;
using dealii::Tensor;
using Signorini::Mesh;

namespace
{
  const double pi = 3.14159265358979323846;

  // Errors of meshes whose cells are halved from one to the next fall by four.
  void
  check_second_order(const std::vector<double> &values, const double exact)
  {
    for (unsigned int i = 1; i < values.size(); ++i)
      {
        const double rate =
          std::log2((exact - values[i - 1]) / (exact - values[i]));
        BOOST_TEST(std::abs(rate - 2.) < 0.15, "rate " << rate);
      }
    BOOST_TEST(std::abs(values.back() - exact) < 0.02 * exact);
  }

  // Volume and size of the rim under refinement, against the exact ones.
  template <int dim>
  void
  check_round(const std::string &lines,
              const double       exact_volume,
              const double       exact_rim)
  {
    std::vector<double> volumes, rims;
    for (unsigned int n = 0; n < 3; ++n)
      {
        const Mesh<dim> mesh = mesh_from<dim>(refined(lines, n));
        BOOST_TEST(error_of_enclosure(mesh) < (dim == 2 ? 1e-13 : 1e-12));
        volumes.push_back(volume(mesh));
        rims.push_back(measure(mesh, "rim").area);
      }
    check_second_order(volumes, exact_volume);
    check_second_order(rims, exact_rim);
  }

  // Largest distance of a vertex of the boundary from a sphere.
  template <int dim>
  double
  distance_from_sphere(const Mesh<dim>   &mesh,
                       const std::string &name,
                       const Point<dim>  &center,
                       const double       radius)
  {
    double     largest = 0.;
    const auto id      = mesh.boundary(name);
    for (const auto &face : mesh.triangulation->active_face_iterators())
      if (face->at_boundary() && face->boundary_id() == id)
        for (const unsigned int v : face->vertex_indices())
          largest =
            std::max(largest,
                     std::abs(face->vertex(v).distance(center) - radius));
    return largest;
  }

  // The smallest determinant of the three (two) unit vectors along the edges of
  // a corner, over all cells: 1 for rectangular ones, 0 for flat corners.
  template <int dim>
  double
  worst_corner(const Mesh<dim> &mesh)
  {
    double smallest = 1.;
    for (const auto &cell : mesh.triangulation->active_cell_iterators())
      for (const unsigned int v : cell->vertex_indices())
        {
          Tensor<2, dim> edges;
          for (unsigned int d = 0; d < dim; ++d)
            {
              const unsigned int bit = 1u << d;
              edges[d] = cell->vertex(v | bit) - cell->vertex(v & ~bit);
              edges[d] /= edges[d].norm();
            }
          smallest = std::min(smallest, determinant(edges));
        }
    return smallest;
  }
} // namespace



BOOST_AUTO_TEST_CASE(disc)
{
  const std::string lines = "set Mesh = disc\n"
                            "subsection Disc\n"
                            "  set Centre = 3, -1\n"
                            "  set Radius = 2\n"
                            "  set Initial refinements = 1\n"
                            "end\n";
  check_round<2>(lines, 4. * pi, 4. * pi);

  const Mesh<2> mesh = mesh_from<2>(refined(lines, 3));
  BOOST_TEST(mesh.triangulation->n_active_cells() == 12u * 256u);
  BOOST_TEST(names_of(mesh.boundaries) == "rim");
  BOOST_TEST(distance_from_sphere(mesh, "rim", Point<2>(3., -1.), 2.) < 1e-14);
  // No flat or re-entrant corners at the rim however fine the mesh is.
  BOOST_TEST(worst_corner(mesh) > 0.6);
}

BOOST_AUTO_TEST_CASE(ball)
{
  const std::string lines = "set Mesh = ball\n"
                            "subsection Ball\n"
                            "  set Centre = 1, 2, 3\n"
                            "  set Radius = 0.5\n"
                            "  set Initial refinements = 1\n"
                            "end\n";
  check_round<3>(lines, pi / 6., pi);
  for (unsigned int n = 0; n < 3; ++n)
    BOOST_TEST(worst_corner(mesh_from<3>(refined(lines, n))) > 0.3);
  BOOST_TEST(distance_from_sphere(
               mesh_from<3>(lines), "rim", Point<3>(1., 2., 3.), 0.5) < 1e-14);
}

BOOST_AUTO_TEST_CASE(half_disc)
{
  const std::vector<std::pair<std::string, Tensor<1, 2>>> sides = {
    {"left", Tensor<1, 2>({-1., 0.})},
    {"right", Tensor<1, 2>({1., 0.})},
    {"bottom", Tensor<1, 2>({0., -1.})},
    {"top", Tensor<1, 2>({0., 1.})}};
  const Point<2> center(0.5, 2.);
  for (const auto &[side, normal] : sides)
    {
      const std::string lines = "set Mesh = half disc\n"
                                "subsection Half disc\n"
                                "  set Centre = 0.5, 2\n"
                                "  set Radius = 0.25\n"
                                "  set Initial refinements = 2\n"
                                "  set Flat side = " +
                                side + "\nend\n";
      const Mesh<2> mesh = mesh_from<2>(lines);
      BOOST_TEST(names_of(mesh.boundaries) == "flat,rim");
      check_flat(mesh, "flat", 0.5, normal);
      BOOST_TEST(distance_from_sphere(mesh, "rim", center, 0.25) < 1e-15);
      // The cut goes through the centre.
      BOOST_TEST(std::abs(measure(mesh, "flat").flux -
                          0.5 * (normal * Tensor<1, 2>(center))) < 1e-15);
      BOOST_TEST(worst_corner(mesh) > 0.5);
      check_round<2>(lines, pi / 32., pi / 4.);
    }
}

BOOST_AUTO_TEST_CASE(half_ball)
{
  const std::vector<std::pair<std::string, Tensor<1, 3>>> sides = {
    {"left", Tensor<1, 3>({-1., 0., 0.})},
    {"right", Tensor<1, 3>({1., 0., 0.})},
    {"bottom", Tensor<1, 3>({0., -1., 0.})},
    {"top", Tensor<1, 3>({0., 1., 0.})},
    {"back", Tensor<1, 3>({0., 0., -1.})},
    {"front", Tensor<1, 3>({0., 0., 1.})}};
  const std::string begin = "set Mesh = half ball\n"
                            "subsection Half ball\n"
                            "  set Centre = 0, 1, 0.5\n"
                            "  set Radius = 2\n"
                            "  set Initial refinements = 1\n"
                            "  set Flat side = ";
  for (const auto &[side, normal] : sides)
    {
      const Mesh<3> mesh = mesh_from<3>(begin + side + "\nend\n");
      const auto    flat = measure(mesh, "flat");
      // The circle around the cut has corners; the direction is exact.
      BOOST_TEST((flat.normal - flat.area * normal).norm() < 1e-13);
      BOOST_TEST(std::abs(flat.flux -
                          flat.area * (normal * Tensor<1, 3>({0., 1., 0.5}))) <
                 1e-13);
      BOOST_TEST(error_of_enclosure(mesh) < 1e-12);
      BOOST_TEST(distance_from_sphere(mesh, "rim", Point<3>(0., 1., 0.5), 2.) <
                 1e-14);
    }
  for (unsigned int n = 0; n < 3; ++n)
    BOOST_TEST(worst_corner(mesh_from<3>(refined(begin + "top\nend\n", n))) >
               0.3);
  check_round<3>(begin + "top\nend\n", 16. / 3. * pi, 8. * pi);

  std::vector<double> areas;
  for (unsigned int n = 0; n < 3; ++n)
    areas.push_back(
      measure(mesh_from<3>(refined(begin + "top\nend\n", n)), "flat").area);
  check_second_order(areas, 4. * pi);
}

BOOST_AUTO_TEST_CASE(quarter_disc)
{
  for (const bool top : {false, true})
    {
      const std::string lines = std::string("set Mesh = half ball\n"
                                            "subsection Half ball\n"
                                            "  set Centre = 0, 0.01\n"
                                            "  set Radius = 0.01\n"
                                            "  set Initial refinements = 2\n"
                                            "  set Flat side = ") +
                                (top ? "top" : "bottom") + "\nend\n";
      const Mesh<2> mesh = mesh_from<2>(lines, "", "axisymmetric");
      BOOST_TEST(names_of(mesh.boundaries) == "axis,flat,rim");
      check_flat(mesh, "axis", 0.01, Tensor<1, 2>({-1., 0.}));
      check_flat(mesh, "flat", 0.01, Tensor<1, 2>({0., top ? 1. : -1.}));
      BOOST_TEST(distance_from_sphere(mesh, "rim", Point<2>(0., 0.01), 0.01) <
                 1e-16);
      check_round<2>(lines, pi / 4. * 1e-4, pi / 2. * 1e-2);

      // The axis has not a digit of a radius; the body lies on its side.
      const auto axis = mesh.boundary("axis");
      for (const auto &face : mesh.triangulation->active_face_iterators())
        if (face->at_boundary() && face->boundary_id() == axis)
          BOOST_TEST(face->vertex(0)[0] == 0.);
      for (const auto &vertex : mesh.triangulation->get_vertices())
        {
          BOOST_TEST(vertex[0] >= 0.);
          BOOST_TEST((top ? 0.01 - vertex[1] : vertex[1] - 0.01) >= 0.);
        }
    }
}

BOOST_AUTO_TEST_SUITE_END()
