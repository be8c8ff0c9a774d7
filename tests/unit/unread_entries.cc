#include <signorini/input/input_error.h>
#include <signorini/input/unread_entries.h>

#include <boost/test/unit_test.hpp>

#include <string>

#include "temporary_folder.h"

BOOST_AUTO_TEST_SUITE(unread_entries)

using namespace dealii;
using namespace Signorini;

namespace
{
  void
  declare(ParameterHandler &prm)
  {
    prm.enter_subsection("Body");
    prm.declare_entry("Shape", "plane", Patterns::Selection("plane|circle"));
    prm.declare_entry("Free", "", Patterns::Anything());
    prm.declare_entry("Mass", "0", Patterns::Double());
    prm.declare_entry("Moment", "", Patterns::Anything());
    prm.enter_subsection("Circle");
    prm.declare_entry("Radius", "1", Patterns::Double());
    prm.declare_entry("Side", "outside", Patterns::Anything());
    prm.leave_subsection();
    prm.leave_subsection();
    prm.enter_subsection("Contact");
    prm.declare_entry("Surface",
                      "spline",
                      Patterns::Selection("spline|facets"));
    prm.declare_entry("Knots", "chords", Patterns::Anything());
    prm.enter_subsection("Pair a");
    prm.declare_entry("Surface", "", Patterns::Selection("spline|facets|"));
    prm.declare_entry("Knots", "", Patterns::Anything());
    prm.leave_subsection();
    prm.leave_subsection();
    prm.enter_subsection("Time");
    prm.declare_entry("Analysis", "dynamic", Patterns::Anything());
    prm.leave_subsection();
  }

  ConditionList
  conditions()
  {
    ConditionList list;
    list.add({"Body"},
             {contradiction(read_with({"Circle"}, "Shape", {"circle"})),
              contradiction(read_if_set({"Mass"}, "Free")),
              read_with({"Mass"}, "Time/Analysis", {"dynamic"}),
              read_if_listed({"Moment"}, "Free", "rotation")});
    list.add({"Contact"}, {read_with({"Knots"}, "Surface", {"spline"})});
    list.add({"Contact", "Pair a"},
             {read_with({"Knots"}, "Surface", {"spline"})});
    return list;
  }

  struct Result
  {
    std::string error;
    std::string warnings;
  };

  /** Of a file and, if it is not empty, of another one that it includes. */
  Result
  find(const std::string &text,
       const std::string &included   = "",
       const std::string &assignment = "")
  {
    const TemporaryFolder folder;
    write_file(folder.file("b.prm"), included);
    write_file(folder.file("a.prm"), "include b.prm\n" + text);
    ParameterFile file = ParameterFile::read(folder.file("a.prm"));
    if (!assignment.empty())
      file.override_entry(assignment);
    ParameterHandler prm, defaults;
    declare(prm);
    declare(defaults);
    file.apply(prm);
    // Only the name of the file.
    const auto shortened = [&](std::string message) {
      const std::string path = folder.path.string() + "/";
      for (std::size_t at = message.find(path); at != std::string::npos;
           at             = message.find(path))
        message.erase(at, path.size());
      return message;
    };
    Result result;
    try
      {
        for (const std::string &warning :
             warnings_of_unread_entries(file, conditions(), prm, defaults))
          result.warnings += shortened(warning) + "\n";
      }
    catch (const InputError &error)
      {
        result.error = shortened(error.what());
      }
    return result;
  }

  const std::string circle =
    "subsection Body\nsubsection Circle\nset Radius = 1\nend\nend\n";
} // namespace



BOOST_AUTO_TEST_CASE(what_is_read_is_passed)
{
  for (const std::string &text :
       {std::string("subsection Body\nset Shape = circle\nend\n") + circle,
        std::string("subsection Body\nset Free = x\nset Mass = 2\nend\n"),
        std::string("subsection Body\nset Mass = 0.0\nend\n"), // the default
        std::string("subsection Body\nsubsection Circle\nend\nend\n"),
        // As the program lists all entries
        std::string("subsection Body\nset Shape = plane\nsubsection Circle\n"
                    "set Radius = 1\nset Side = outside\nend\nend\n"),
        std::string("subsection Body\nset Free = x, rotation\nset Moment = "
                    "1\nend\n")})
    {
      const Result result = find(text);
      BOOST_TEST(result.error == "", text);
      BOOST_TEST(result.warnings == "", text);
    }
}

BOOST_AUTO_TEST_CASE(contradictions_are_errors)
{
  BOOST_TEST(find(circle).error ==
             "a.prm:3: Body / Circle: has no effect, since Shape = plane by "
             "default. Set Shape = circle, or remove it.");
  BOOST_TEST(find("subsection Body\nset Shape = plane\nend\n" + circle).error ==
             "a.prm:6: Body / Circle: has no effect, since Shape = plane. Set "
             "Shape = circle, or remove it.");
  BOOST_TEST(find("subsection Body\nset Mass = 2\nend\n").error ==
             "a.prm:3: Body / Mass: has no effect, since Free is not set. Set "
             "Free, or remove it.");
}

BOOST_AUTO_TEST_CASE(leftovers_are_warnings)
{
  const std::string warning =
    "b.prm:2: Body / Circle: has no effect, since Shape = plane. Set Shape = "
    "circle, or remove it.\n";
  BOOST_TEST(
    find("subsection Body\nset Shape = plane\nend\n", circle).warnings ==
    warning);
  BOOST_TEST(find("",
                  circle + "subsection Body\nset Shape = circle\nend\n",
                  "Body/Shape=plane")
               .warnings == warning);
  BOOST_TEST(
    find("subsection Body\nset Moment = 1\nend\n").warnings ==
    "a.prm:3: Body / Moment: has no effect, since Free is not set. Add "
    "rotation to Free, or remove it.\n");
}

BOOST_AUTO_TEST_CASE(choice_of_another_section)
{
  BOOST_TEST(
    find("subsection Body\nset Free = x\nset Mass = 1\nend\n"
         "subsection Time\nset Analysis = static\nend\n")
      .warnings ==
    "a.prm:4: Body / Mass: has no effect, since Analysis = static. Set "
    "Analysis = dynamic, or remove it.\n");
}

BOOST_AUTO_TEST_CASE(choices_of_pairs)
{
  const std::string begin = "subsection Contact\n", end = "end\n";
  const std::string facets = "set Surface = facets\n",
                    knots  = "set Knots = u\n";
  const std::string pair   = "subsection Pair a\n";
  BOOST_TEST(find(begin + facets + knots + end).warnings != "");
  BOOST_TEST(find(begin + facets + pair + knots + end + end).warnings != "");
  // One pair is enough, and has its own.
  BOOST_TEST(
    find(begin + facets + knots + pair + "set Surface = spline\n" + end + end)
      .warnings == "");
  BOOST_TEST(
    find(begin + facets + pair + "set Surface = spline\n" + knots + end + end)
      .warnings == "");
  BOOST_TEST(find(begin + pair + facets + knots + end + end).warnings != "");
}

BOOST_AUTO_TEST_SUITE_END()
