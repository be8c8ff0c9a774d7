#include <deal.II/base/exceptions.h>
#include <deal.II/grid/grid_in.h>

#include <boost/test/unit_test.hpp>

#include "mesh_measures.h"
#include "temporary_folder.h"

BOOST_AUTO_TEST_SUITE(mesh_file)

using Signorini::Mesh;

namespace
{
  const std::string folder =
    (std::filesystem::path(__FILE__).parent_path() / "meshes").string();

  std::string
  file_lines(const std::string &name)
  {
    return "set Mesh = file\nsubsection File\n set Name = " + name + "\nend\n";
  }

  template <int dim>
  Mesh<dim>
  read(const std::string &name)
  {
    return mesh_from<dim>(file_lines(name), folder);
  }

  std::string
  sample(const std::string &name)
  {
    return read_file(folder + "/" + name);
  }

  double
  area_of_region(const Mesh<2> &mesh, const std::string &name)
  {
    double sum = 0.;
    for (const auto &cell : mesh.triangulation->active_cell_iterators())
      if (cell->material_id() == mesh.regions.at(name))
        sum += cell->measure();
    return sum;
  }

  void
  check_normal(const Mesh<2>              &mesh,
               const std::string          &name,
               const double                length,
               const dealii::Tensor<1, 2> &normal)
  {
    // The files have coordinates with 12 right digits.
    BOOST_TEST(std::abs(measure(mesh, name).area - length) < 1e-11);
    BOOST_TEST((measure(mesh, name).normal - length * normal).norm() < 1e-11);
  }

  // The plate of plate.geo, whichever format it is in.
  void
  check_plate(const Mesh<2> &mesh, const std::string &right_side)
  {
    BOOST_TEST(mesh.triangulation->n_active_cells() == 8u);
    BOOST_TEST(std::abs(volume(mesh) - 2.) < 1e-11);
    check_normal(mesh, "bottom", 2., dealii::Tensor<1, 2>({0., -1.}));
    check_normal(mesh, right_side, 1., dealii::Tensor<1, 2>({1., 0.}));
    check_normal(mesh, "top", 2., dealii::Tensor<1, 2>({0., 1.}));
    check_normal(mesh, "left", 1., dealii::Tensor<1, 2>({-1., 0.}));
    BOOST_TEST(error_of_enclosure(mesh) < 1e-11);
    BOOST_TEST(std::abs(area_of_region(mesh, "steel") - 1.) < 1e-11);
    BOOST_TEST(std::abs(area_of_region(mesh, "rubber") - 1.) < 1e-11);
    for (const auto &cell : mesh.triangulation->active_cell_iterators())
      BOOST_TEST(cell->material_id() ==
                 mesh.regions.at(cell->center()[0] < 1. ? "steel" : "rubber"));
  }

} // namespace



BOOST_AUTO_TEST_CASE(gmsh_plate)
{
  for (const std::string name : {"plate_41.msh", "plate_22.msh"})
    {
      const Mesh<2> mesh = read<2>(name);
      check_plate(mesh, "right side");
      // The interface lies inside and is no boundary.
      BOOST_TEST(names_of(mesh.boundaries) == "bottom,left,right side,top");
      BOOST_TEST(names_of(mesh.regions) == "rubber,steel");
    }
}

BOOST_AUTO_TEST_CASE(like_the_reader_of_the_library)
{
  // deal.II's reader keeps Gmsh's physical tags as ids, but not the names.
  // It refuses the interface, so that the brick has to do.
  dealii::Triangulation<3> triangulation;
  dealii::GridIn<3>        reader;
  reader.attach_triangulation(triangulation);
  std::ifstream file(folder + "/brick.msh");
  reader.read_msh(file);

  const Mesh<3>                             mesh = read<3>("brick.msh");
  const std::map<std::string, unsigned int> tags = {{"back", 1},
                                                    {"front", 2},
                                                    {"bottom", 3}};
  for (const auto &[name, tag] : tags)
    {
      double area = 0.;
      for (const auto &face : triangulation.active_face_iterators())
        if (face->at_boundary() && face->boundary_id() == tag)
          area += face->measure();
      BOOST_TEST(std::abs(measure(mesh, name).area - area) < 1e-12);
    }
  BOOST_TEST(triangulation.n_active_cells() ==
             mesh.triangulation->n_active_cells());
}

BOOST_AUTO_TEST_CASE(gmsh_brick)
{
  for (const std::string name : {"brick.msh", "brick_gmsh.inp"})
    {
      const Mesh<3> mesh = read<3>(name);
      BOOST_TEST(mesh.triangulation->n_active_cells() == 6u);
      BOOST_TEST(std::abs(volume(mesh) - 6.) < 1e-12);
      const auto back = measure(mesh, "back"), front = measure(mesh, "front"),
                 bottom = measure(mesh, "bottom");
      BOOST_TEST((back.normal - dealii::Tensor<1, 3>({0., 0., -2.})).norm() <
                 1e-12);
      BOOST_TEST((front.normal - dealii::Tensor<1, 3>({0., 0., 2.})).norm() <
                 1e-12);
      BOOST_TEST((bottom.normal - dealii::Tensor<1, 3>({0., -3., 0.})).norm() <
                 1e-12);
      BOOST_TEST(std::abs(front.flux - 6.) < 1e-12);
      // The three sides without a name have the id 0.
      double unnamed = 0.;
      for (const auto &face : mesh.triangulation->active_face_iterators())
        if (face->at_boundary() && face->boundary_id() == 0)
          unnamed += face->measure();
      BOOST_TEST(std::abs(unnamed - 15.) < 1e-12);
      BOOST_TEST(mesh.regions.count("brick") == 1u);
    }
}

BOOST_AUTO_TEST_CASE(abaqus_from_gmsh)
{
  const Mesh<2> mesh = read<2>("plate_gmsh.inp");
  check_plate(mesh, "right_side");
  // A set of the pre-processor with the same edges is the same boundary; one
  // that is only a part of a named set is left out.
  BOOST_TEST(mesh.boundary("Line3") == mesh.boundary("right_side"));
  BOOST_TEST(mesh.boundaries.count("Line1") == 0u);
}

BOOST_AUTO_TEST_CASE(abaqus_surfaces)
{
  const Mesh<2> mesh = read<2>("square.inp");
  BOOST_TEST(mesh.triangulation->n_active_cells() == 4u);
  BOOST_TEST(std::abs(volume(mesh) - 4.) < 1e-14);
  BOOST_TEST(names_of(mesh.boundaries) == "Floor side,Lid");
  check_normal(mesh, "Floor side", 2., dealii::Tensor<1, 2>({0., -1.}));
  check_normal(mesh, "Lid", 2., dealii::Tensor<1, 2>({0., 1.}));
  BOOST_TEST(names_of(mesh.regions) == "Lower,Upper");
  BOOST_TEST(std::abs(area_of_region(mesh, "Upper") - 2.) < 1e-14);
  for (const auto &cell : mesh.triangulation->active_cell_iterators())
    BOOST_TEST(cell->material_id() ==
               mesh.regions.at(cell->center()[1] < 1. ? "Lower" : "Upper"));

  const Mesh<3> bricks = read<3>("bricks.inp");
  BOOST_TEST(names_of(bricks.boundaries) == "x0,x1,y0,y1,z0,z2");
  BOOST_TEST(names_of(bricks.regions) == "body");
  for (const auto &[name, id] : bricks.boundaries)
    {
      const unsigned int   axis = name[0] - 'x';
      dealii::Tensor<1, 3> exact;
      exact[axis] = (axis == 2 ? 1. : 2.) * (name[1] == '0' ? -1. : 1.);
      BOOST_TEST((measure(bricks, name).normal - exact).norm() < 1e-14);
    }
  BOOST_TEST(error_of_enclosure(bricks) < 1e-14);
}

BOOST_AUTO_TEST_CASE(scale_and_refinement)
{
  const Mesh<2> mesh = mesh_from<2>("set Mesh = file\n"
                                    "set Refinements towards = Lid : 1\n"
                                    "subsection File\n"
                                    "  set Name  = square.inp\n"
                                    "  set Scale = 1e-3\n"
                                    "end\n",
                                    folder);
  BOOST_TEST(mesh.triangulation->n_active_cells() == 2u + 8u);
  BOOST_TEST(std::abs(volume(mesh) - 4e-6) < 1e-20);
  BOOST_TEST(std::abs(measure(mesh, "Lid").area - 2e-3) < 1e-17);
  BOOST_TEST(measure(mesh, "Lid").n_faces == 4u);
}

BOOST_AUTO_TEST_CASE(example_beam)
{
  const std::string meshes = folder + "/../../../prm/meshes";
  const Mesh<2>     mesh   = mesh_from<2>(file_lines("beam.msh"), meshes);
  BOOST_TEST(mesh.triangulation->n_active_cells() == 640u);
  BOOST_TEST(names_of(mesh.boundaries) == "bottom,left,right,top");
  BOOST_TEST(names_of(mesh.regions) == "beam");
  BOOST_TEST(std::abs(volume(mesh) - 4e-3) < 1e-14);
  check_normal(mesh, "bottom", 0.2, dealii::Tensor<1, 2>({0., -1.}));
  check_normal(mesh, "left", 0.02, dealii::Tensor<1, 2>({-1., 0.}));
  BOOST_TEST(measure(mesh, "top").n_faces == 80u);
  BOOST_TEST(measure(mesh, "right").n_faces == 8u);
}

BOOST_AUTO_TEST_CASE(groups_without_names)
{
  std::string       text  = sample("plate_22.msh");
  const std::size_t begin = text.find("$PhysicalNames");
  const std::size_t end   = text.find("$Nodes");
  text.erase(begin, end - begin);
  const TemporaryFolder temporary;
  write_file(temporary.file("a.msh"), text);
  const Mesh<2> mesh =
    mesh_from<2>(file_lines("a.msh"), temporary.path.string());
  BOOST_TEST(names_of(mesh.boundaries) == "1,2,3,4");
  BOOST_TEST(names_of(mesh.regions) == "6,7");
  BOOST_TEST(std::abs(measure(mesh, "1").area - 2.) < 1e-11);
}

BOOST_AUTO_TEST_SUITE_END()
