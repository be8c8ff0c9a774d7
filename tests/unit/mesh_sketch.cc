#include <signorini/geometry/mesh_examples.h>
#include <signorini/geometry/mesh_sketch.h>

#include <deal.II/grid/grid_tools.h>

#include <boost/test/unit_test.hpp>

#include <set>

BOOST_AUTO_TEST_SUITE(mesh_sketch)

using namespace Signorini;

namespace
{
  bool
  contains(const std::string &text, const std::string &part)
  {
    return text.find(part) != std::string::npos;
  }

  template <int dim>
  void
  check_names()
  {
    for (const MeshExample &example : mesh_examples<dim>())
      {
        const Mesh<dim>   mesh   = create_example<dim>(example);
        const std::string sketch = Signorini::mesh_sketch(mesh);
        for (const auto &boundary : mesh.boundaries)
          BOOST_TEST((contains(sketch, ">" + boundary.first + "</text>") ||
                      contains(sketch, ">" + boundary.first + " (behind)<")),
                     example.generator << ": " << boundary.first);
      }
  }

  Mesh<3>
  box()
  {
    return create_example<3>({"box", "", {}});
  }

  // Of the words after "text x" until the name.
  double
  place(const std::string &sketch, const std::string &name, const char axis)
  {
    const auto end   = sketch.find(">" + name + "<");
    const auto begin = sketch.rfind("<text", end);
    const auto found = sketch.find(std::string(1, axis) + "=\"", begin);
    BOOST_REQUIRE(end != std::string::npos && found < end);
    return std::stod(sketch.substr(found + 3));
  }
} // namespace



BOOST_AUTO_TEST_CASE(all_boundaries_have_their_names)
{
  check_names<2>();
  check_names<3>();
}

BOOST_AUTO_TEST_CASE(all_variants_are_shown)
{
  std::set<std::string> names;
  for (const MeshExample &example : mesh_examples<2>())
    for (const auto &boundary : create_example<2>(example).boundaries)
      names.insert(example.generator + "." + boundary.first);
  for (const char *name : {"ring.start",
                           "pinion.end",
                           "rack.back",
                           "blade root.contact_3",
                           "blade root.contact_3_left",
                           "disc sector.side",
                           "disc sector.side_right",
                           "half ball.axis"})
    BOOST_TEST(names.count(name) == 1, name);
}

BOOST_AUTO_TEST_CASE(sides_of_a_rectangle)
{
  const std::string sketch =
    Signorini::mesh_sketch(create_example<2>({"rectangle", "", {}}));
  BOOST_TEST(place(sketch, "left", 'x') < place(sketch, "bottom", 'x'));
  BOOST_TEST(place(sketch, "bottom", 'x') < place(sketch, "right", 'x'));
  // y goes down in a picture.
  BOOST_TEST(place(sketch, "top", 'y') < place(sketch, "left", 'y'));
  BOOST_TEST(place(sketch, "left", 'y') < place(sketch, "bottom", 'y'));
}

BOOST_AUTO_TEST_CASE(what_is_seen_of_a_box)
{
  const std::string sketch = Signorini::mesh_sketch(box());
  for (const char *name : {"right", "top", "front"})
    BOOST_TEST(contains(sketch, std::string(">") + name + "<"), name);
  for (const char *name : {"left", "bottom", "back"})
    BOOST_TEST(contains(sketch, std::string(">") + name + " (behind)<"), name);
  BOOST_TEST(place(sketch, "left (behind)", 'x') < place(sketch, "right", 'x'));
  BOOST_TEST(place(sketch, "top", 'y') < place(sketch, "front", 'y'));
}

// The width of the picture divided by 16 is a whole number and a half.
BOOST_AUTO_TEST_CASE(rounding_changes_nothing)
{
  Mesh<2> mesh = create_example<2>({"rectangle", "", {{"Cells", "16, 16"}}});
  const std::string exact = Signorini::mesh_sketch(mesh);
  unsigned int      n     = 0;
  dealii::GridTools::transform(
    [&](const dealii::Point<2> &p) {
      dealii::Point<2> moved = p;
      for (unsigned int d = 0; d < 2; ++d)
        moved[d] += (++n % 3 - 1.) * 1e-14;
      return moved;
    },
    *mesh.triangulation);
  BOOST_TEST(Signorini::mesh_sketch(mesh) == exact);
}

BOOST_AUTO_TEST_SUITE_END()
