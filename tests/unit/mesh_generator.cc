#include <signorini/geometry/shapes/block.h>

#include <boost/test/unit_test.hpp>

#include "mesh_measures.h"

BOOST_AUTO_TEST_SUITE(mesh_generator)

using dealii::Point;
using dealii::Tensor;
using Signorini::Mesh;

namespace
{
  const double pi = 3.14159265358979323846;

} // namespace



BOOST_AUTO_TEST_CASE(rectangle)
{
  const Mesh<2> mesh = mesh_from<2>("set Mesh = rectangle\n"
                                    "subsection Rectangle\n"
                                    "  set Corners = -0.1, 0.3 ; 0.2, 0.7\n"
                                    "  set Cells   = 6, 5\n"
                                    "  set Grading = 4, 0.125\n"
                                    "end\n");
  BOOST_TEST(mesh.triangulation->n_active_cells() == 30u);
  BOOST_TEST(names_of(mesh.boundaries) == "bottom,left,right,top");
  BOOST_TEST(names_of(mesh.regions) == "body");
  BOOST_TEST(std::abs(volume(mesh) - 0.12) < 1e-15);
  check_flat(mesh, "left", 0.4, Tensor<1, 2>({-1., 0.}));
  check_flat(mesh, "right", 0.4, Tensor<1, 2>({1., 0.}));
  check_flat(mesh, "bottom", 0.3, Tensor<1, 2>({0., -1.}));
  check_flat(mesh, "top", 0.3, Tensor<1, 2>({0., 1.}));
  BOOST_TEST(error_of_enclosure(mesh) < 1e-13);

  // The four cells in the corners have the first and the last sizes.
  std::array<double, 2> first = {}, last = {};
  for (const auto &cell : mesh.triangulation->active_cell_iterators())
    for (unsigned int d = 0; d < 2; ++d)
      {
        const double size = cell->vertex(3)[d] - cell->vertex(0)[d];
        if (cell->vertex(0)[d] == (d == 0 ? -0.1 : 0.3))
          first[d] = size;
        if (cell->vertex(3)[d] == (d == 0 ? 0.2 : 0.7))
          last[d] = size;
      }
  BOOST_TEST(std::abs(last[0] / first[0] - 4.) < 1e-12);
  BOOST_TEST(std::abs(last[1] / first[1] - 0.125) < 1e-12);
}

BOOST_AUTO_TEST_CASE(graded_points)
{
  // Sizes 1, 2, 4, 8 between 0 and 15.
  const std::vector<double> points = Signorini::graded_points(0., 15., 4, 8.);
  const std::vector<double> exact  = {0., 1., 3., 7., 15.};
  for (unsigned int i = 0; i < 5; ++i)
    BOOST_TEST(std::abs(points[i] - exact[i]) < 1e-14);
  // Without grading each point is the nearest number to begin + i h.
  const std::vector<double> uniform = Signorini::graded_points(0., 1., 10, 1.);
  for (unsigned int i = 0; i <= 10; ++i)
    BOOST_TEST(uniform[i] == i / 10.);
}

BOOST_AUTO_TEST_CASE(turned_rectangle)
{
  const Mesh<2> mesh = mesh_from<2>("subsection Rectangle\n"
                                    "  set Corners = 1, 0 ; 3, 1\n"
                                    "  set Cells   = 4, 2\n"
                                    "  set Angle   = 30\n"
                                    "end\n");
  const double  c = std::sqrt(0.75), s = 0.5;
  BOOST_TEST(std::abs(volume(mesh) - 2.) < 1e-14);
  check_flat(mesh, "left", 1., Tensor<1, 2>({-c, -s}));
  check_flat(mesh, "bottom", 2., Tensor<1, 2>({s, -c}));
  // About the origin: the bottom stays on a line through it.
  BOOST_TEST(std::abs(measure(mesh, "bottom").flux) < 1e-15);

  // Right angles leave no rounding errors.
  const Mesh<2> quarter = mesh_from<2>("subsection Rectangle\n"
                                       "  set Corners = 0, 0 ; 0.3, 0.7\n"
                                       "  set Angle   = 90\n"
                                       "end\n");
  for (const Point<2> &vertex : quarter.triangulation->get_vertices())
    {
      BOOST_TEST((vertex[0] == 0. || vertex[0] == -0.7));
      BOOST_TEST((vertex[1] == 0. || vertex[1] == 0.3));
    }
}

BOOST_AUTO_TEST_CASE(box)
{
  const Mesh<3> mesh = mesh_from<3>("set Mesh = box\n"
                                    "subsection Box\n"
                                    "  set Corners = 0, -1, 2 ; 1, 1, 5\n"
                                    "  set Cells   = 1, 2, 3\n"
                                    "  set Grading = 1, 2, 3\n"
                                    "end\n");
  BOOST_TEST(mesh.triangulation->n_active_cells() == 6u);
  BOOST_TEST(names_of(mesh.boundaries) == "back,bottom,front,left,right,top");
  BOOST_TEST(std::abs(volume(mesh) - 6.) < 1e-13);
  check_flat(mesh, "left", 6., Tensor<1, 3>({-1., 0., 0.}));
  check_flat(mesh, "right", 6., Tensor<1, 3>({1., 0., 0.}));
  check_flat(mesh, "bottom", 3., Tensor<1, 3>({0., -1., 0.}));
  check_flat(mesh, "top", 3., Tensor<1, 3>({0., 1., 0.}));
  check_flat(mesh, "back", 2., Tensor<1, 3>({0., 0., -1.}));
  check_flat(mesh, "front", 2., Tensor<1, 3>({0., 0., 1.}));
  for (const auto &cell : mesh.triangulation->active_cell_iterators())
    BOOST_TEST(cell->material_id() == mesh.regions.at("body"));
}

BOOST_AUTO_TEST_CASE(ring)
{
  struct Case
  {
    std::string angles;
    double      degrees;
  };
  for (const Case &part : {Case{"0, 360", 360.},
                           Case{"-90, 90", 180.},
                           Case{"90, 180", 90.},
                           Case{"10, 80", 70.}})
    {
      const std::string lines = "set Mesh = ring\n"
                                "subsection Ring\n"
                                "  set Centre = 1, 1\n"
                                "  set Inner radius = 0.5\n"
                                "  set Outer radius = 0.75\n"
                                "  set Cells = 12, 3\n"
                                "  set Angles = " +
                                part.angles + "\nend\n";
      for (unsigned int n = 0; n < 2; ++n)
        {
          // Polygons: n_around triangles with the angle delta in the centre.
          const Mesh<2> mesh     = mesh_from<2>(refined(lines, n));
          const double  n_around = 12 * (n + 1);
          const double  delta    = part.degrees / n_around * pi / 180.;
          const double  chord    = 2. * n_around * std::sin(delta / 2.);
          const double  area =
            n_around * std::sin(delta) / 2. * (0.75 * 0.75 - 0.5 * 0.5);
          BOOST_TEST(mesh.triangulation->n_active_cells() == 36u * (n ? 4 : 1));
          BOOST_TEST(std::abs(volume(mesh) - area) < 1e-14);
          BOOST_TEST(std::abs(measure(mesh, "inner").area - 0.5 * chord) <
                     1e-14);
          BOOST_TEST(std::abs(measure(mesh, "outer").area - 0.75 * chord) <
                     1e-14);
          BOOST_TEST(error_of_enclosure(mesh) < 1e-13);
          BOOST_TEST(
            names_of(mesh.boundaries) ==
            (part.degrees == 360. ? "inner,outer" : "end,inner,outer,start"));
        }
    }

  const Mesh<2> half = mesh_from<2>("set Mesh = ring\n"
                                    "subsection Ring\n"
                                    "  set Angles = -90, 90\n"
                                    "end\n",
                                    "",
                                    "axisymmetric");
  check_flat(half, "start", 0.5, Tensor<1, 2>({-1., 0.}));
  check_flat(half, "end", 0.5, Tensor<1, 2>({-1., 0.}));
  BOOST_TEST(measure(half, "start").flux == 0.); // on x = 0, to the last digit
  const Mesh<2> quarter = mesh_from<2>("set Mesh = ring\n"
                                       "subsection Ring\n"
                                       "  set Angles = 0, 90\n"
                                       "end\n");
  check_flat(quarter, "start", 0.5, Tensor<1, 2>({0., -1.}));
  check_flat(quarter, "end", 0.5, Tensor<1, 2>({-1., 0.}));
}

BOOST_AUTO_TEST_CASE(tube)
{
  const std::string begin = "set Mesh = tube\n"
                            "subsection Tube\n"
                            "  set Centre = 1, 2, 3\n"
                            "  set Inner radius = 0.5\n"
                            "  set Outer radius = 1\n"
                            "  set Length = 4\n"
                            "  set Cells = 8, 1, 2\n";
  for (const bool full : {true, false})
    for (unsigned int n = 0; n < 2; ++n)
      {
        const Mesh<3> mesh = mesh_from<3>(
          refined(begin + (full ? "end\n" : "set Angles = 0, 180\nend\n"), n));
        const double n_around = 8 * (n + 1);
        const double delta    = (full ? 2. : 1.) * pi / n_around;
        const double section  = n_around * std::sin(delta) / 2. * 0.75;
        const double chord    = 2. * n_around * std::sin(delta / 2.);
        BOOST_TEST(std::abs(volume(mesh) - 4. * section) < 1e-13);
        check_flat(mesh, "back", section, Tensor<1, 3>({0., 0., -1.}));
        check_flat(mesh, "front", section, Tensor<1, 3>({0., 0., 1.}));
        BOOST_TEST(std::abs(measure(mesh, "back").flux + 3. * section) < 1e-13);
        BOOST_TEST(std::abs(measure(mesh, "inner").area - 2. * chord) < 1e-13);
        BOOST_TEST(std::abs(measure(mesh, "outer").area - 4. * chord) < 1e-13);
        if (!full)
          {
            check_flat(mesh, "start", 2., Tensor<1, 3>({0., -1., 0.}));
            check_flat(mesh, "end", 2., Tensor<1, 3>({0., -1., 0.}));
          }
        BOOST_TEST(error_of_enclosure(mesh) < 1e-13);
        BOOST_TEST(names_of(mesh.boundaries) ==
                   (full ? "back,front,inner,outer" :
                           "back,end,front,inner,outer,start"));
      }
}

BOOST_AUTO_TEST_CASE(names_of_boundaries)
{
  const Mesh<2> mesh = mesh_from<2>("");
  BOOST_TEST(mesh.boundary("top") == mesh.boundaries.at("top"));
  BOOST_CHECK_EXCEPTION(
    mesh.boundary("botom"),
    Signorini::InputError,
    [](const Signorini::InputError &error) {
      return std::string(error.what()) ==
             "The mesh has no boundary \"botom\". Its boundaries are: bottom, "
             "left, right, top. Did you mean \"bottom\"?";
    });
}

BOOST_AUTO_TEST_CASE(axial_symmetry)
{
  const std::string left = "subsection Rectangle\n"
                           "  set Corners = -1, 0 ; 1, 1\n"
                           "end\n";
  BOOST_TEST(error_from<2>(left, "", "plane strain") == "");
  BOOST_TEST(
    contains(error_from<2>(left, "", "axisymmetric"), "a vertex at (-1 0)"));

  const std::string off_axis = "set Mesh = half ball\n"
                               "subsection Half ball\n"
                               "  set Centre = 0.5, 0\n"
                               "end\n";
  BOOST_TEST(error_from<2>(off_axis, "", "plane strain") == "");
  BOOST_TEST(contains(error_from<2>(off_axis, "", "axisymmetric"),
                      "\"axis\" must lie on x = 0"));
}

BOOST_AUTO_TEST_CASE(wrong_entries)
{
  const auto check = [](const std::string &mesh,
                        const std::string &section,
                        const std::string &entry,
                        const std::string &value,
                        const std::string &reason,
                        const int          dim = 2) {
    const std::string lines = "set Mesh = " + mesh + "\nsubsection " + section +
                              "\n set " + entry + " = " + value + "\nend\n";
    const std::string error =
      dim == 2 ? error_from<2>(lines) : error_from<3>(lines);
    BOOST_TEST(contains(error, section + " / " + entry + " = " + value + ": "),
               lines << error);
    BOOST_TEST(contains(error, reason), lines << error);
  };
  check("rectangle", "Rectangle", "Cells", "0, 8", "less than 1");
  check("rectangle", "Rectangle", "Cells", "4, -8", "less than 1");
  check("rectangle", "Rectangle", "Cells", "5000, 5000", "20 million");
  check("disc", "Disc", "Initial refinements", "99999999", "20 million");
  check("rectangle", "Rectangle", "Corners", "1, 0 ; 0, 1", "less than");
  check("rectangle", "Rectangle", "Corners", "0, 1 ; 1, 1", "less than");
  check("rectangle", "Rectangle", "Grading", "0, 1", "1e-6");
  check("rectangle", "Rectangle", "Grading", "2, 1", "single cell");
  check("box", "Box", "Cells", "1, 1, 0", "less than 1", 3);
  check("disc", "Disc", "Radius", "0", "greater than zero");
  check("disc", "Disc", "Initial refinements", "-1", "less than 0");
  check("half disc", "Half disc", "Radius", "-1", "greater than zero");
  check("half ball", "Half ball", "Radius", "-1", "greater than zero");
  check("half ball", "Half ball", "Radius", "-1", "greater than zero", 3);
  check("ball", "Ball", "Radius", "-1", "greater than zero", 3);
  check("ring", "Ring", "Inner radius", "0", "greater than zero");
  check("ring", "Ring", "Outer radius", "0.5", "Inner radius = 0.5");
  check("ring", "Ring", "Angles", "90, 90", "greater than the first");
  check("ring", "Ring", "Angles", "0, 361", "not more than 360");
  check("ring", "Ring", "Cells", "2, 1", "120 degrees");
  check("ring", "Ring", "Cells", "12, 0", "less than 1");
  check("tube", "Tube", "Length", "0", "greater than zero", 3);
  check("tube", "Tube", "Cells", "12, 1, 0", "less than 1", 3);
}

BOOST_AUTO_TEST_SUITE_END()
