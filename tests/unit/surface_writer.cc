#include <signorini/output/surface_writer.h>

#include <boost/test/unit_test.hpp>

#include "temporary_folder.h"
#include "vtu_reader.h"

BOOST_AUTO_TEST_SUITE(surface_writer)

using namespace dealii;
using namespace Signorini;

namespace
{
  // Three nodes, two lines that share the second one.
  SurfaceData<2>
  line()
  {
    SurfaceData<2> surface;
    surface.name          = "beam.bottom on floor";
    surface.nodes         = {{0., 0.}, {1., 0.5}, {3., 0.}};
    surface.faces         = {{0, 1}, {1, 2}};
    surface.scalar_fields = {{"gap", {0.25, 0., 0.5}},
                             {"pressure", {0., 4., 0.}}};
    surface.vector_fields = {
      {"normal", {Point<2>(0., 1.), Point<2>(0.5, 0.25), Point<2>(0., -1.)}}};
    return surface;
  }

  SurfaceData<3>
  square()
  {
    SurfaceData<3> surface;
    surface.name  = "square";
    surface.nodes = {{0., 0., 2.}, {1., 0., 2.}, {0., 1., 2.}, {1., 1., 2.}};
    surface.faces = {{0, 1, 2, 3}};
    surface.scalar_fields = {{"gap", {1., 2., 3., 4.}}};
    surface.vector_fields = {
      {"traction", std::vector<Tensor<1, 3>>(4, Point<3>(1., 2., 3.))}};
    return surface;
  }
} // namespace



// All numbers are exact in single precision.
BOOST_AUTO_TEST_CASE(lines_in_the_plane)
{
  const TemporaryFolder folder;
  SurfaceWriter<2>      writer(folder.path.string());
  writer.write({line()}, 0.5);
  const VtuReader vtu(read_file(folder.file("beam.bottom_on_floor_00000.vtu")));
  using Values = std::vector<double>;
  BOOST_TEST(vtu.number("NumberOfCells") == 2u);
  BOOST_TEST(vtu.array("Points") ==
             (Values{0., 0., 0., 1., .5, 0., 1., .5, 0., 3., 0., 0.}));
  BOOST_TEST(vtu.array("connectivity") == (Values{0., 1., 2., 3.}));
  BOOST_TEST(vtu.array("gap") == (Values{0.25, 0., 0., 0.5}));
  BOOST_TEST(vtu.array("pressure") == (Values{0., 4., 4., 0.}));
  BOOST_TEST(vtu.array("normal") ==
             (Values{0., 1., 0., .5, .25, 0., .5, .25, 0., 0., -1., 0.}));
  BOOST_TEST(vtu.array("TIME") == Values{0.5});
}

BOOST_AUTO_TEST_CASE(quadrilaterals_in_space)
{
  const TemporaryFolder folder;
  SurfaceWriter<3>(folder.path.string()).write({square()}, 0.);
  const VtuReader vtu(read_file(folder.file("square_00000.vtu")));
  using Values = std::vector<double>;
  BOOST_TEST(vtu.number("NumberOfCells") == 1u);
  const Values points = vtu.array("Points");
  // VTK goes around the face: no crossed quadrilateral.
  Values around;
  for (const double vertex : vtu.array("connectivity"))
    for (unsigned int d = 0; d < 3; ++d)
      around.push_back(points[3 * static_cast<unsigned int>(vertex) + d]);
  BOOST_TEST(around ==
             (Values{0., 0., 2., 1., 0., 2., 1., 1., 2., 0., 1., 2.}));
  const Values gap = vtu.array("gap");
  for (unsigned int i = 0; i < 4; ++i)
    BOOST_TEST(gap[i] == 1. + points[3 * i] + 2. * points[3 * i + 1]);
  BOOST_TEST(vtu.array("traction") ==
             (Values{1., 2., 3., 1., 2., 3., 1., 2., 3., 1., 2., 3.}));
}

BOOST_AUTO_TEST_CASE(a_surface_without_fields)
{
  const TemporaryFolder folder;
  SurfaceData<2>        floor;
  floor.name  = "floor";
  floor.nodes = {{-1., 0.}, {1., 0.}};
  floor.faces = {{0, 1}};
  SurfaceWriter<2>(folder.path.string()).write({floor}, 0.);
  const VtuReader vtu(read_file(folder.file("floor_00000.vtu")));
  BOOST_TEST(vtu.number("NumberOfPoints") == 2u);
}

BOOST_AUTO_TEST_CASE(a_collection_over_time)
{
  const TemporaryFolder folder;
  SurfaceWriter<2>      writer(folder.path.string());
  SurfaceData<2>        other = line();
  other.name                  = "a < b";
  writer.write({line(), other}, 0.);
  writer.write({line(), other}, 1e-6);
  BOOST_TEST(writer.collection().n_outputs() == 2u);
  const std::string text = read_file(folder.file("contact.pvd"));
  for (const std::string part :
       {"timestep=\"0\" part=\"0\" name=\"beam.bottom on floor\" "
        "file=\"beam.bottom_on_floor_00000.vtu\"",
        "timestep=\"1e-06\" part=\"1\" name=\"a &lt; b\" "
        "file=\"a___b_00001.vtu\""})
    BOOST_TEST(text.find(part) != std::string::npos, text);
}

BOOST_AUTO_TEST_SUITE_END()
