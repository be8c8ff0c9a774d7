#include <boost/test/unit_test.hpp>

#include <filesystem>

#include "mesh_measures.h"

BOOST_AUTO_TEST_SUITE(mesh_cutout)

using dealii::Point;
using dealii::Tensor;
using Signorini::Mesh;

namespace
{
  const std::string square = "set Mesh = rectangle\n"
                             "subsection Rectangle\n"
                             "  set Cells = 8, 8\n"
                             "end\n";

  std::string
  near(const std::string &places)
  {
    return "set Keep cells near = " + places + "\n";
  }

  // Places to search: rounded coordinates, so that equal points are found.
  template <int dim>
  std::array<long, dim>
  key(const Point<dim> &p, const double size)
  {
    std::array<long, dim> result;
    for (unsigned int d = 0; d < dim; ++d)
      result[d] = std::lround(p[d] / (1e-12 * size));
    return result;
  }

  // What is known of a cell, face or line: ids by the mean of its corners.
  template <int dim>
  using Ids = std::map<std::array<long, dim>, unsigned int>;

  template <int dim>
  struct Census
  {
    Ids<dim> boundaries, lines, materials;
  };

  // The mean of the vertices stays the same number whatever their order.
  template <typename Object, int dim>
  Point<dim>
  middle(const Object &object, const Point<dim> &)
  {
    std::vector<Point<dim>> corners;
    for (unsigned int v = 0; v < object->n_vertices(); ++v)
      corners.push_back(object->vertex(v));
    std::sort(corners.begin(), corners.end(), [](const auto &a, const auto &b) {
      return std::lexicographical_compare(a.begin_raw(),
                                          a.end_raw(),
                                          b.begin_raw(),
                                          b.end_raw());
    });
    Point<dim> sum;
    for (const auto &corner : corners)
      sum += corner / double(corners.size());
    return sum;
  }

  template <int dim>
  Census<dim>
  census(const Mesh<dim> &mesh, const double size)
  {
    Census<dim> result;
    for (const auto &cell : mesh.triangulation->active_cell_iterators())
      {
        result.materials[key(middle(cell, Point<dim>()), size)] =
          cell->material_id();
        for (const auto &face : cell->face_iterators())
          result.boundaries[key(middle(face, Point<dim>()), size)] =
            face->boundary_id();
        for (unsigned int l = 0; l < cell->n_lines(); ++l)
          result.lines[key(middle(cell->line(l), Point<dim>()), size)] =
            cell->line(l)->boundary_id();
      }
    return result;
  }

  // Same places with the same ids; what was inside may be on the cut.
  template <int dim>
  unsigned int
  n_differences(const Ids<dim> &part, const Ids<dim> &whole, const int cut = -1)
  {
    unsigned int n = 0;
    for (const auto &[place, id] : part)
      {
        const auto found = whole.find(place);
        const bool same =
          found != whole.end() &&
          (found->second == id ||
           (int(id) == cut &&
            found->second == dealii::numbers::internal_face_boundary_id));
        n += same ? 0 : 1;
      }
    return n;
  }

  // With the assertions of deal.II the finest meshes take a minute.
#ifdef DEBUG
  constexpr unsigned int n_refinements = 2;
#else
  constexpr unsigned int n_refinements = 3;
#endif

  // The part refines to cells of the refined whole, with the same ids. Returns
  // the number of cells.
  template <int dim>
  unsigned int
  check_part(const std::string &lines,
             const std::string &places,
             const std::string &names,
             const double       size           = 1.,
             const std::string &base_directory = "")
  {
    unsigned int n_cells = 0;
    for (unsigned int n = 0; n < n_refinements; ++n)
      BOOST_TEST_CONTEXT(lines << n << " refinements")
      {
        const Mesh<dim> whole =
          mesh_from<dim>(refined(lines, n), base_directory);
        const Mesh<dim> part =
          mesh_from<dim>(refined(lines + near(places), n), base_directory);
        if (n == 0)
          n_cells = part.triangulation->n_active_cells();
        BOOST_TEST(part.triangulation->n_active_cells() ==
                   n_cells * (1u << (dim * n)));
        BOOST_TEST(n_cells < whole.triangulation->n_active_cells() >>
                   (dim * n));
        BOOST_TEST(names_of(part.boundaries) == names);
        for (const auto &[name, id] : part.boundaries)
          if (name != "cut")
            BOOST_TEST(id == whole.boundaries.at(name), name);
        for (const auto &[name, id] : part.regions)
          BOOST_TEST(id == whole.regions.at(name), name);
        BOOST_TEST(error_of_enclosure(part) < 1e-11);

        const Census<dim> of_whole = census(whole, size);
        const Census<dim> of_part  = census(part, size);
        const int         cut      = part.boundary("cut");
        BOOST_TEST(n_differences<dim>(of_part.materials, of_whole.materials) ==
                   0u);
        BOOST_TEST(n_differences<dim>(of_part.boundaries,
                                      of_whole.boundaries,
                                      cut) == 0u);
        BOOST_TEST(n_differences<dim>(of_part.lines, of_whole.lines, cut) ==
                   0u);
      }
    return n_cells;
  }
} // namespace



BOOST_AUTO_TEST_CASE(part_of_a_square)
{
  // Cells of 1/8: four by two, see the refinements near a point.
  const Mesh<2> mesh = mesh_from<2>(square + near("0.5, 0 : 0.2"));
  BOOST_TEST(mesh.triangulation->n_active_cells() == 8u);
  BOOST_TEST(names_of(mesh.boundaries) == "bottom,cut");
  BOOST_TEST(names_of(mesh.regions) == "body");
  BOOST_TEST(std::abs(volume(mesh) - 8. / 64.) < 1e-15);
  check_flat(mesh, "bottom", 0.5, Tensor<1, 2>({0., -1.}));
  BOOST_TEST(std::abs(measure(mesh, "cut").area - 1.) < 1e-14);
  BOOST_TEST(error_of_enclosure(mesh) < 1e-14);

  // Two parts; a circle inside of one cell.
  const Mesh<2> two =
    mesh_from<2>(square + near("0.05, 0.05 : 0.01 ; 0.9, 0.9 : 0.2"));
  BOOST_TEST(std::abs(volume(two) - (1. + 8.) / 64.) < 1e-15);
  BOOST_TEST(names_of(two.boundaries) == "bottom,cut,left,right,top");

  const Mesh<3> cube = mesh_from<3>("subsection Box\n"
                                    "  set Cells = 4, 4, 4\n"
                                    "end\n" +
                                    near("1, 1, 1 : 0.45"));
  BOOST_TEST(std::abs(volume(cube) - 8. / 64.) < 1e-15);
  BOOST_TEST(names_of(cube.boundaries) == "cut,front,right,top");
  BOOST_TEST(std::abs(measure(cube, "cut").area - 0.75) < 1e-14);

  // The refinements come afterwards and know the cut.
  const Mesh<2> finer = mesh_from<2>(square + near("0.5, 0 : 0.2") +
                                     "set Refinements towards = cut : 1\n");
  BOOST_TEST(finer.triangulation->n_active_cells() == 2u + 4u * 6u);
}

BOOST_AUTO_TEST_CASE(nothing_or_everything)
{
  const Mesh<2> whole = mesh_from<2>(square + near("0.5, 0.5 : 9"));
  BOOST_TEST(whole.triangulation->n_active_cells() == 64u);
  BOOST_TEST(names_of(whole.boundaries) == "bottom,left,right,top");

  // Without the entry the mesh stays as it is, with its levels.
  BOOST_TEST(mesh_from<2>("set Mesh = disc\n").triangulation->n_levels() == 4u);
}

BOOST_AUTO_TEST_CASE(curved_boundaries)
{
  check_part<2>("set Mesh = ring\n", "1, 0 : 0.4", "cut,inner,outer");
  check_part<2>("set Mesh = disc\n", "1, 0 : 0.3", "cut,rim");
  check_part<2>("set Mesh = blade root\n",
                "0.0096, 0.2676 : 0.002",
                "contact_2,cut,free",
                0.1);
  check_part<2>("set Mesh = disc sector\n",
                "0, 0.2 : 0.005 ; 0.0096, 0.2676 : 0.002",
                "bore,contact_2,cut,free,symmetry",
                0.1);
  check_part<2>("set Mesh = pinion\n",
                "0.0081, 0.0031 : 0.003",
                "cut,left_2,roots",
                0.01);
  check_part<2>("set Mesh = rack\n",
                "0.0016, -0.0044 : 0.003",
                "cut,right_2,roots",
                0.01);
  check_part<3>("set Mesh = tube\n", "1, 0, 0 : 0.3", "back,cut,inner,outer");
  check_part<3>("set Mesh = ball\n", "1, 0, 0 : 0.3", "cut,rim");
  check_part<3>("set Mesh = half ball\n",
                "0, 0, 0 : 0.3 ; 1, 0, 0 : 0.2",
                "cut,flat,rim");
}

BOOST_AUTO_TEST_CASE(a_refined_ring_is_round)
{
  const Mesh<2> mesh = mesh_from<2>(
    "set Mesh = ring\nset Global refinements = 4\n" + near("0, 1 : 0.4"));
  unsigned int n_faces = 0;
  for (const auto &[name, radius] :
       {std::make_pair("inner", 0.5), std::make_pair("outer", 1.)})
    for (const auto &face : mesh.triangulation->active_face_iterators())
      if (face->at_boundary() && face->boundary_id() == mesh.boundary(name))
        for (const unsigned int v : face->vertex_indices())
          {
            ++n_faces;
            BOOST_TEST(std::abs(face->vertex(v).norm() - radius) < 1e-14);
          }
  BOOST_TEST(n_faces >= 64u);
}

BOOST_AUTO_TEST_CASE(regions)
{
  const std::string meshes =
    (std::filesystem::path(__FILE__).parent_path() / "meshes").string();
  const std::string plate =
    "set Mesh = file\nsubsection File\n set Name = plate_41.msh\nend\n";
  const Mesh<2> steel = mesh_from<2>(plate + near("0, 0 : 0.1"), meshes);
  BOOST_TEST(names_of(steel.boundaries) == "bottom,cut,left");
  BOOST_TEST(names_of(steel.regions) == "steel");
  check_part<2>(plate, "1, 0 : 0.1", "bottom,cut", 1., meshes);
  BOOST_TEST(
    names_of(mesh_from<2>(plate + near("1, 0 : 0.1"), meshes).regions) ==
    "rubber,steel");
}

BOOST_AUTO_TEST_CASE(wrong_entries)
{
  for (const std::string text : {"0, 0",
                                 "0 : 1",
                                 "0, 0, 0 : 1",
                                 "0, 0 : 0",
                                 "0, 0 : -1",
                                 "0, 0 : 1 : 1",
                                 "0, y : 1",
                                 "0, 0 : nan"})
    {
      const std::string error = error_from<2>(near(text));
      BOOST_TEST(contains(error, "Keep cells near = " + text), text << error);
      BOOST_TEST(contains(error, "cannot understand \"" + text + "\""), error);
      BOOST_TEST(contains(error, "`x, y : radius'"), error);
    }
  BOOST_TEST(contains(error_from<3>(near("0, 0 : 1")), "`x, y, z : radius'"));

  const std::string error = error_from<2>(square + near("3, 4 : 1 ; 9, 9 : 1"));
  BOOST_TEST(contains(error, "Keep cells near: no cell of the mesh"), error);
  BOOST_TEST(contains(error, "between (0 0) and (1 1)"), error);
  BOOST_TEST(error_from<2>(square + near("2, 0 : 1")) == ""); // it touches

  // A name that is gone gets the usual message.
  const std::string name = error_from<2>(square + near("0.5, 0 : 0.2") +
                                         "set Refinements towards = top : 1\n");
  BOOST_TEST(contains(name, "no boundary \"top\""), name);
  BOOST_TEST(contains(name, "bottom, cut"), name);
}

BOOST_AUTO_TEST_SUITE_END()
