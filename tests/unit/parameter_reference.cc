#include <signorini/input/parameter_json.h>
#include <signorini/input/parameter_reference.h>

#include <boost/test/unit_test.hpp>

BOOST_AUTO_TEST_SUITE(parameter_reference)

using namespace dealii;
using namespace Signorini;

namespace
{
  void
  declare_side(const unsigned int dim, ParameterHandler &prm)
  {
    prm.enter_subsection("Side");
    prm.declare_entry("Length", "1", Patterns::Double(), "How long. Unit: m.");
    if (dim == 3)
      prm.declare_entry("Depth", "2", Patterns::Double(), "Unit: m.");
    prm.leave_subsection();
  }

  // The point has as many numbers as there are dimensions, and one section is
  // only in 3-D.
  DeclaredProblem
  problem(const unsigned int dim)
  {
    ParameterHandler prm;
    prm.declare_entry("Point", dim == 2 ? "0, 0" : "0, 0, 0");
    prm.declare_entry("Law", "soft", Patterns::Selection("soft|hard"));
    declare_side(dim, prm);
    if (dim == 3)
      {
        prm.enter_subsection("Bottom");
        declare_side(dim, prm);
        prm.leave_subsection();
      }
    DeclaredProblem result;
    result.parameters = declared_parameters(prm);
    result.conditions.add({"Side"}, {read_with({"Length"}, "Law", {"hard"})});
    if (dim == 3)
      result.conditions.add({}, {read_if_set({"Side"}, "Point")});
    return result;
  }

  std::vector<ReferenceSection>
  sections()
  {
    return Signorini::parameter_reference(problem(2), problem(3));
  }
} // namespace



BOOST_AUTO_TEST_CASE(sections_of_both_dimensions)
{
  const std::vector<ReferenceSection> list = sections();
  BOOST_TEST_REQUIRE(list.size() == 4);
  BOOST_TEST(list[0].path.empty());
  BOOST_TEST(list[1].path == std::vector<std::string>{"Side"},
             boost::test_tools::per_element());
  BOOST_TEST(list[3].path == (std::vector<std::string>{"Bottom", "Side"}),
             boost::test_tools::per_element());
  BOOST_TEST(list[1].is_in_2d);
  BOOST_TEST(!list[3].is_in_2d);
  BOOST_TEST(list[3].is_in_3d);
}

BOOST_AUTO_TEST_CASE(entries_of_both_dimensions)
{
  const std::vector<ReferenceSection> list = sections();
  BOOST_TEST_REQUIRE(list[0].entries.size() == 2);
  const ReferenceEntry &point = list[0].entries[0];
  BOOST_TEST(point.name == "Point");
  BOOST_TEST(point.in_2d->default_value == "0, 0");
  BOOST_TEST(point.in_3d->default_value == "0, 0, 0");
  BOOST_TEST_REQUIRE(list[1].entries.size() == 2);
  const ReferenceEntry &depth = list[1].entries[1];
  BOOST_TEST(depth.name == "Depth");
  BOOST_TEST(!depth.in_2d.has_value());
  BOOST_TEST(depth.in_3d.has_value());
}

BOOST_AUTO_TEST_CASE(remedies)
{
  const std::vector<ReferenceSection> list   = sections();
  const Remedies                      length = list[1].entries[0].remedies;
  BOOST_TEST(length.in_2d == std::vector<std::string>{"Set Law = hard"},
             boost::test_tools::per_element());
  BOOST_TEST(list[1].remedies.in_2d.empty());
  BOOST_TEST(list[1].remedies.in_3d == std::vector<std::string>{"Set Point"},
             boost::test_tools::per_element());
  // The condition is on the one at the top.
  BOOST_TEST(list[3].entries[0].remedies.in_3d.empty());
}

BOOST_AUTO_TEST_CASE(same_entries)
{
  const std::vector<ReferenceSection> list = sections();
  BOOST_TEST(have_same_entries(list[1], list[1]));
  // One of them is in 3-D only.
  BOOST_TEST(!have_same_entries(list[1], list[3]));
  BOOST_TEST(!have_same_entries(list[0], list[1]));
}

BOOST_AUTO_TEST_CASE(units)
{
  BOOST_TEST(split_unit("How long. Unit: m.").text == "How long.");
  BOOST_TEST(split_unit("How long. Unit: m.").unit == "m");
  BOOST_TEST(split_unit("A circle. Unit of the radius: m.").unit ==
             "m (the radius)");
  BOOST_TEST(split_unit("Pairs. Units: 1 and Pa.").unit == "1 and Pa");
  BOOST_TEST(split_unit("The unit: none. More.").text ==
             "The unit: none. More.");
  BOOST_TEST(split_unit("The unit: none. More.").unit == "");
}

BOOST_AUTO_TEST_CASE(json)
{
  ParameterHandler prm;
  prm.enter_subsection("Pair a.b on \"c\"");
  prm.declare_entry("File", "x\\y", Patterns::Anything(), "Two\nlines.");
  prm.set("File", std::string("z"));
  prm.leave_subsection();
  BOOST_TEST(parameter_json(declared_parameters(prm)) ==
             "{\n \"Pair a.b on \\\"c\\\"\": {\n"
             "  \"File\": {\"value\": \"z\", \"default_value\": \"x\\\\y\", "
             "\"documentation\": \"Two\\u000alines.\", "
             "\"pattern_description\": \"[Anything]\"}\n }\n}\n");
}

BOOST_AUTO_TEST_SUITE_END()
