#include <signorini/dynamics/unheld_bodies.h>
#include <signorini/input/input_error.h>

#include <boost/test/unit_test.hpp>

#include "contact_setup.h"
#include "contains.h"

BOOST_AUTO_TEST_SUITE(unheld_bodies)

using namespace Signorini;
using namespace dealii;

namespace
{
  FrictionLaw
  friction(const std::string &coefficient)
  {
    return FrictionLaw::parse({},
                              {[&](const std::string &name) {
                                 return name == "Friction coefficient" ?
                                          coefficient :
                                          "";
                               },
                               [](const std::string &name) { return name; }});
  }

  // What is said of one body and one rigid body; empty if they are held.
  std::string
  message(const std::string &block,
          const std::string &boundary,
          const std::string &tool,
          const std::string &coefficient)
  {
    const BodyOnTool setup(block, boundary, tool, friction(coefficient));
    try
      {
        refuse_unheld_bodies(setup.solid,
                             setup.contact,
                             setup.tools,
                             Vector<double>(setup.solid.n_dofs()),
                             1.);
      }
    catch (const InputError &error)
      {
        return error.what();
      }
    return "";
  }

  std::string
  on_floor(const std::string &traction,
           const std::string &coefficient = "0",
           const std::string &supports    = "",
           const std::string &normal      = "0, 1")
  {
    return message(
      rectangle("0, 0 ; 2, 1",
                "4, 2",
                1,
                "subsection Loads\n set Traction = top: " + traction +
                  "\nend\nsubsection Supports\n set Fixed = " + supports +
                  "\nend\n"),
      "bottom",
      "set Shape = plane\nsubsection Plane\n set Normal = " + normal +
        "\nend\n",
      coefficient);
  }

  // A circle above a block that stands firmly.
  std::string
  under_punch(const std::string &punch, const std::string &centre = "1")
  {
    return message(
      rectangle("0, 0 ; 2, 1",
                "4, 2",
                1,
                "subsection Supports\n set Fixed = bottom: x, y\nend\n"),
      "top",
      "set Shape = circle\nsubsection Circle\n set Centre = " + centre +
        ", 1.5\n set Radius = 0.5\nend\nset Centre of rotation = " + centre +
        ", 1.5\n" + punch,
      "0");
  }
} // namespace



BOOST_AUTO_TEST_CASE(block_on_a_floor)
{
  BOOST_TEST(on_floor("0 ; -1").empty());
  const std::string up = on_floor("0 ; 1");
  BOOST_TEST(contains(up, "Body a"));
  BOOST_TEST(contains(up, "translation along y"));
  const std::string aside = on_floor("0.1 ; -1");
  BOOST_TEST(contains(aside, "translation along x"));
  BOOST_TEST(on_floor("0.1 ; -1", "0", "left: x").empty());
  BOOST_TEST(!on_floor("0 ; 1", "0", "left: x").empty());
  BOOST_TEST(!on_floor("0 ; 1", "0.5").empty());
}



// Pushed by 0.29 or 0.31 of its weight at mu = 0.3; it is wide enough not to
// topple. With mu = 3 it topples at twice its weight: the moment 2 of the push
// at height 1 exceeds that of the weight, 1.
BOOST_AUTO_TEST_CASE(friction_holds)
{
  BOOST_TEST(on_floor("0.29 ; -1", "0.3").empty());
  BOOST_TEST(on_floor("-0.29 ; -1", "0.3").empty());
  BOOST_TEST(contains(on_floor("0.31 ; -1", "0.3"), "translation along x"));
  BOOST_TEST(on_floor("0.9 ; -1", "3").empty());
  BOOST_TEST(!on_floor("2 ; -1", "3").empty());
}



// On a slope of 20 degrees a block holds if mu > tan 20.
BOOST_AUTO_TEST_CASE(slope)
{
  const double angle = 20. * numbers::PI / 180.;
  const auto   held  = [&](const double factor) {
    return on_floor(std::to_string(std::sin(angle)) + " ; " +
                      std::to_string(-std::cos(angle)),
                    std::to_string(factor * std::tan(angle)))
      .empty();
  };
  BOOST_TEST(held(1.01));
  BOOST_TEST(!held(0.99));
}



BOOST_AUTO_TEST_CASE(free_rigid_punch)
{
  BOOST_TEST(under_punch("set Free = y\nset Force = 0 ; -5\n").empty());
  const std::string away = under_punch("set Free = y\nset Force = 0 ; 5\n");
  BOOST_TEST(contains(away, "Rigid body tool"));
  BOOST_TEST(contains(away, "translation along y"));
  // The load is that of the end, not of the beginning.
  BOOST_TEST(!under_punch("set Free = y\nset Force = 0 ; 5*t\n").empty());
  BOOST_TEST(under_punch("set Free = y\nset Force = 0 ; -5*t\n").empty());
  BOOST_TEST(contains(under_punch("set Free = y, rotation\n"
                                  "set Force = 0 ; -5\nset Moment = 1\n"),
                      "rotation"));
}



// A frictionless circle on the middle node of a flat. The next nodes, 0.5 from
// there and 0.5 below its centre, look as if they could hold it, and do so in
// the valley between two of them if the push is less than tan 30 of the
// weight; with more it goes over the edge. If the circle is pressed down by a
// given motion nothing is known.
BOOST_AUTO_TEST_CASE(circle_pushed_along_a_flat)
{
  const std::string free = "set Free = x, y\nset Force = ";
  BOOST_TEST(under_punch(free + "0 ; -5\n").empty());
  BOOST_TEST(under_punch(free + "2.8 ; -5\n").empty());
  for (const std::string push : {"3 ; -5\n", "-3 ; -5\n"})
    {
      const std::string along = under_punch(free + push);
      BOOST_TEST(contains(along, "Rigid body tool"));
      BOOST_TEST(contains(along, "translation along x"));
    }
  BOOST_TEST(under_punch("set Free = x\nset Force = 3 ; 0\n"
                         "set Motion = 0 ; -0.1*t\n")
               .empty());
}



// What is held only after it has moved: a block that falls flat, one that falls
// on a corner and then on its side, a circle that rolls to the next node.
BOOST_AUTO_TEST_CASE(contacts_that_close_later)
{
  const std::string load =
    "subsection Loads\n set Traction = top: 0 ; -1\nend\n";
  const std::string floor = "set Shape = plane\nsubsection Plane\n"
                            " set Normal = 0, 1\nend\n";
  for (const double angle : {0., 10.})
    BOOST_TEST(
      message(turned_rectangle("0, 0.5 ; 2, 1.5", "4, 2", 1, angle) + load,
              "bottom",
              floor,
              "0")
        .empty());
  for (const std::string centre : {"0.93", "1.2", "1.25"})
    BOOST_TEST(
      under_punch("set Free = x, y\nset Force = 0 ; -5\n", centre).empty());
}

BOOST_AUTO_TEST_SUITE_END()
