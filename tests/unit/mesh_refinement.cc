#include <signorini/geometry/boundary_distance.h>
#include <signorini/geometry/refinement_passes.h>

#include <boost/test/unit_test.hpp>

#include <random>

#include "mesh_measures.h"

BOOST_AUTO_TEST_SUITE(mesh_refinement)

using dealii::Point;
using Signorini::Mesh;

namespace
{
  const std::string square = "set Mesh = rectangle\n"
                             "subsection Rectangle\n"
                             "  set Cells = 8, 8\n"
                             "end\n";

  // Number of cells for each level.
  template <int dim>
  std::vector<unsigned int>
  census(const Mesh<dim> &mesh)
  {
    std::vector<unsigned int> n(mesh.triangulation->n_levels(), 0);
    for (const auto &cell : mesh.triangulation->active_cell_iterators())
      ++n[cell->level()];
    return n;
  }

  // Largest difference of levels around a vertex.
  template <int dim>
  int
  largest_jump(const Mesh<dim> &mesh)
  {
    std::map<unsigned int, std::pair<int, int>> levels;
    for (const auto &cell : mesh.triangulation->active_cell_iterators())
      for (const unsigned int v : cell->vertex_indices())
        {
          auto &range =
            levels
              .insert({cell->vertex_index(v), {cell->level(), cell->level()}})
              .first->second;
          range.first  = std::min(range.first, cell->level());
          range.second = std::max(range.second, cell->level());
        }
    int jump = 0;
    for (const auto &[vertex, range] : levels)
      jump = std::max(jump, range.second - range.first);
    return jump;
  }

  using Census = std::vector<unsigned int>;
} // namespace



BOOST_AUTO_TEST_CASE(everywhere)
{
  BOOST_TEST(census(mesh_from<2>(square + "set Global refinements = 2\n")) ==
               (Census{0, 0, 1024}),
             boost::test_tools::per_element());
  BOOST_TEST(census(mesh_from<3>("set Global refinements = 1\n")) ==
               (Census{0, 8}),
             boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(towards_a_boundary)
{
  // 8 of 64 cells in a first pass, 16 of their children in a second one.
  const Mesh<2> mesh =
    mesh_from<2>(square + "set Refinements towards = bottom : 2\n");
  BOOST_TEST(census(mesh) == (Census{56, 16, 64}),
             boost::test_tools::per_element());
  for (const auto &cell : mesh.triangulation->active_cell_iterators())
    BOOST_TEST(cell->level() == (cell->center()[1] < 1. / 16. ? 2 :
                                 cell->center()[1] < 1. / 8.  ? 1 :
                                                                0));
  BOOST_TEST(largest_jump(mesh) == 1);
  BOOST_TEST(std::abs(volume(mesh) - 1.) < 1e-14);
  BOOST_TEST(measure(mesh, "bottom").n_faces == 32u);
  BOOST_TEST(std::abs(measure(mesh, "bottom").area - 1.) < 1e-14);

  // The items one after the other; a cell in a corner is on both.
  const Mesh<2> two =
    mesh_from<2>(square + "set Refinements towards = bottom : 1 ; left : 1\n");
  // 8 cells; then 7 of the first size and 2 of the second one.
  BOOST_TEST(census(two) == (Census{49, 30 + 28, 8}),
             boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(towards_within_a_distance)
{
  // Three rows of height 1/8 have a corner not above 1/4. Of the new rows of
  // height 1/16 five do.
  const Mesh<2> once =
    mesh_from<2>(square + "set Refinements towards = bottom : 1 : 0.25\n");
  BOOST_TEST(census(once) == (Census{40, 96}),
             boost::test_tools::per_element());
  const Mesh<2> twice =
    mesh_from<2>(square + "set Refinements towards = bottom : 2 : 0.25\n");
  BOOST_TEST(census(twice) == (Census{40, 16, 320}),
             boost::test_tools::per_element());

  // Two of four layers have a corner not farther than 0.25 from the front.
  const Mesh<3> cube = mesh_from<3>("subsection Box\n"
                                    "  set Cells = 4, 4, 4\n"
                                    "end\n"
                                    "set Refinements towards = front : 1 : "
                                    "0.25\n");
  BOOST_TEST(census(cube) == (Census{32, 256}),
             boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(towards_a_rim)
{
  const Mesh<2> mesh = mesh_from<2>("set Mesh = disc\n"
                                    "set Refinements towards = rim : 3\n"
                                    "subsection Disc\n"
                                    "  set Initial refinements = 2\n"
                                    "end\n");
  const auto    rim  = mesh.boundary("rim");
  for (const auto &cell : mesh.triangulation->active_cell_iterators())
    for (const auto &face : cell->face_iterators())
      if (face->at_boundary())
        {
          BOOST_TEST(face->boundary_id() == rim);
          BOOST_TEST(cell->level() == 5);
          BOOST_TEST(std::abs(face->vertex(0).norm() - 1.) < 1e-15);
        }
  for (const auto &cell : mesh.triangulation->active_cell_iterators())
    if (cell->center().norm() < 0.5)
      BOOST_TEST(cell->level() == 2);
  BOOST_TEST(largest_jump(mesh) == 1);
}

BOOST_AUTO_TEST_CASE(near_a_point)
{
  // Cells of 1/8: the circle around (0.5, 0) with the radius 0.2 reaches those
  // between 1/4 and 3/4 in the lowest row, and, because the corners at
  // (1/4 + 1/8, 1/8) and (3/4 - 1/8, 1/8) are at a distance of 0.177, the same
  // four in the second row.
  const Mesh<2> mesh =
    mesh_from<2>(square + "set Refinements near = 0.5, 0 : 0.2 : 1\n");
  BOOST_TEST(census(mesh) == (Census{56, 32}),
             boost::test_tools::per_element());
  for (const auto &cell : mesh.triangulation->active_cell_iterators())
    BOOST_TEST(cell->level() == (std::abs(cell->center()[0] - 0.5) < 0.25 &&
                                     cell->center()[1] < 0.25 ?
                                   1 :
                                   0));

  // Around a point inside a cell only this one, however small the circle is.
  const Mesh<3> cube =
    mesh_from<3>("set Refinements near = 0.1, 0.1, 0.1 : 0 : 3\n");
  BOOST_TEST(census(cube) == (Census{0, 7, 7, 8}),
             boost::test_tools::per_element());

  const Mesh<2> two = mesh_from<2>(
    square + "set Refinements near = 0.1, 0.1 : 0 : 1 ; 0.9, 0.9 : 0 : 1\n");
  BOOST_TEST(census(two) == (Census{62, 8}), boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(distances)
{
  // Against the nearest of many points of a triangle, which is at most half a
  // spacing too far away: 2 h / 3 with h = longest edge / 200.
  std::mt19937                     generator(1);
  std::uniform_real_distribution<> number(-1., 1.);
  const auto                       random_point = [&]() {
    return Point<3>(number(generator), number(generator), number(generator));
  };
  for (unsigned int sample = 0; sample < 200; ++sample)
    {
      const std::array<Point<3>, 3> triangle = {
        {random_point(), random_point(), random_point()}};
      const Point<3>     p       = random_point();
      const unsigned int n       = 200;
      double             nearest = 10.;
      for (unsigned int i = 0; i <= n; ++i)
        for (unsigned int j = 0; i + j <= n; ++j)
          nearest = std::min(nearest,
                             p.distance(triangle[0] +
                                        (i * (triangle[1] - triangle[0]) +
                                         j * (triangle[2] - triangle[0])) /
                                          n));
      const double edge     = std::max({triangle[0].distance(triangle[1]),
                                        triangle[1].distance(triangle[2]),
                                        triangle[2].distance(triangle[0])});
      const double distance = Signorini::distance_from(triangle, p);
      BOOST_TEST(distance <= nearest + 1e-14);
      BOOST_TEST(distance >= nearest - 2. * edge / (3. * n));
    }
  const std::array<Point<2>, 2> segment = {
    {Point<2>(0., 0.), Point<2>(4., 3.)}};
  BOOST_TEST(Signorini::distance_from(segment, Point<2>(-3., -4.)) == 5.);
  BOOST_TEST(Signorini::distance_from(segment, Point<2>(1., 2.)) == 1.,
             boost::test_tools::tolerance(1e-14));
  BOOST_TEST(Signorini::distance_from(segment, Point<2>(7., 7.)) == 5.);
}

BOOST_AUTO_TEST_CASE(wrong_entries)
{
  for (const std::string text : {"rim",
                                 "rim : x",
                                 "rim : 1.5",
                                 "rim : -1",
                                 "rim : 31",
                                 "rim : 1 : -1",
                                 "rim : 1 : near",
                                 "rim : 1 : 1 : 1",
                                 " : 1"})
    {
      const std::string error =
        error_from<2>("set Refinements towards = " + text + "\n");
      BOOST_TEST(contains(error, "Refinements towards = "), text << error);
      BOOST_TEST(contains(error, "cannot understand"), text << error);
    }
  for (const std::string text : {"0, 0",
                                 "0 : 1 : 1",
                                 "0, 0, 0 : 1 : 1",
                                 "0, 0 : -1 : 1",
                                 "0, 0 : 1 : x"})
    {
      const std::string error =
        error_from<2>("set Refinements near = " + text + "\n");
      BOOST_TEST(contains(error, "cannot understand"), text << error);
    }
  BOOST_TEST(contains(error_from<2>("set Refinements towards = botom : 1\n"),
                      "Refinements towards: The mesh has no boundary"));
  BOOST_TEST(contains(error_from<2>("set Global refinements = -1\n"),
                      "Global refinements = -1: must not be less than 0"));
  BOOST_TEST(
    contains(error_from<2>("set Global refinements = 31\n"), "0 to 30"));
  // 4^30 cells: known before the work.
  BOOST_TEST(contains(error_from<2>("set Global refinements = 30\n"),
                      "more than 20 million cells"));
}

// Passes give the mesh that was refined step by step; wrong ones are refused.
BOOST_AUTO_TEST_CASE(passes_again)
{
  auto                        first = mesh_from<2>(square);
  Signorini::RefinementPasses passes;
  for (unsigned int i = 0; i < 3; ++i)
    {
      std::vector<bool> flags(first.triangulation->n_active_cells(), false);
      for (const auto &cell : first.triangulation->active_cell_iterators())
        if (cell->center().norm() < 0.3)
          {
            flags[cell->active_cell_index()] = true;
            cell->set_refine_flag();
          }
      first.triangulation->execute_coarsening_and_refinement();
      passes.push_back(flags);
    }
  auto second = mesh_from<2>(square);
  Signorini::refine_again(passes, *second.triangulation);
  BOOST_TEST(census(first).size() == 4u);
  BOOST_TEST(census(second) == census(first), boost::test_tools::per_element());
  auto cell = second.triangulation->begin_active();
  for (const auto &other : first.triangulation->active_cell_iterators())
    BOOST_TEST((cell++)->center().distance(other->center()) == 0.);

  BOOST_CHECK_THROW(Signorini::refine_again(passes, *second.triangulation),
                    Signorini::InputError);
}

BOOST_AUTO_TEST_SUITE_END()
