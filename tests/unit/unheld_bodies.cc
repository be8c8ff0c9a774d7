#include <signorini/contact/rigid_target.h>
#include <signorini/input_error.h>
#include <signorini/simulation/unheld_bodies.h>

#include <boost/test/unit_test.hpp>

#include "contact_setup.h"

BOOST_AUTO_TEST_SUITE(unheld_bodies)

using namespace Signorini;
using namespace dealii;

namespace
{
  FrictionLaw
  friction(const std::string &coefficient)
  {
    return FrictionLaw::parse(
      {},
      [&](const std::string &name) {
        return name == "Friction coefficient" ? coefficient : "";
      },
      [](const std::string &name) { return name; });
  }

  // What is said of one body and one rigid body; empty if they are held.
  std::string
  message(const std::string &block,
          const std::string &boundary,
          const std::string &tool,
          const std::string &coefficient)
  {
    std::vector<SolidModel<2>::Part> parts;
    parts.push_back(test_part<2>("block", block, Formulation::plane_strain, 0));
    const unsigned int n_dofs = parts[0].body->n_dofs();

    ParameterHandler prm;
    RigidBody<2>::declare_parameters(prm);
    prm.parse_input_from_string(tool);
    std::vector<std::unique_ptr<RigidBody<2>>> rigid_bodies;
    rigid_bodies.push_back(
      std::make_unique<RigidBody<2>>("tool", "", Constants(), n_dofs, prm));
    const SolidModel<2> solid(std::move(parts), rigid_bodies[0]->unknowns());

    std::vector<ContactModel<2>::PairDescription> pairs;
    pairs.push_back({solid.parts()[0].body.get(),
                     boundary,
                     std::make_unique<RigidTarget<2>>(*rigid_bodies[0]),
                     friction(coefficient)});
    const ContactModel<2> contact(std::move(pairs),
                                  solid.is_fixed(),
                                  solid.constraints());
    try
      {
        refuse_unheld_bodies(
          solid, contact, rigid_bodies, Vector<double>(solid.n_dofs()), 1.);
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
  under_punch(const std::string &punch)
  {
    return message(
      rectangle("0, 0 ; 2, 1",
                "4, 2",
                1,
                "subsection Supports\n set Fixed = bottom: x, y\nend\n"),
      "top",
      "set Shape = circle\nsubsection Circle\n set Centre = 1, 1.5\n"
      " set Radius = 0.5\nend\nset Centre of rotation = 1, 1.5\n" +
        punch,
      "0");
  }

  bool
  contains(const std::string &text, const std::string &part)
  {
    return text.find(part) != std::string::npos;
  }
} // namespace



BOOST_AUTO_TEST_CASE(block_on_a_floor)
{
  BOOST_TEST(on_floor("0 ; -1").empty());
  const std::string up = on_floor("0 ; 1");
  BOOST_TEST(contains(up, "Body block"));
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

BOOST_AUTO_TEST_SUITE_END()
