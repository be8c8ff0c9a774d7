#include <signorini/input/input_error.h>
#include <signorini/input/parameter_file.h>

#include <boost/test/unit_test.hpp>

#include <unistd.h>

#include <filesystem>
#include <string>

#include "temporary_folder.h"

/** Works in an empty folder of its own and returns afterwards. */
struct EmptyFolder
{
  EmptyFolder()
  {
    std::filesystem::create_directories(folder.path / "prm");
    std::filesystem::current_path(folder.path);
  }

  ~EmptyFolder()
  {
    std::filesystem::current_path(previous);
  }

  const std::filesystem::path previous = std::filesystem::current_path();
  const TemporaryFolder       folder;
};

BOOST_FIXTURE_TEST_SUITE(parameter_file, EmptyFolder)

using namespace dealii;
using namespace Signorini;

// Messages are compared in full: they are what the user sees.
namespace
{
  void
  declare(ParameterHandler &prm)
  {
    prm.declare_entry("Title", "untitled", Patterns::Anything());
    prm.declare_entry("Bodies", "", Patterns::Anything());
    prm.enter_subsection("Body beam");
    prm.declare_entry("Refinements", "0", Patterns::Integer(0));
    prm.enter_subsection("Material");
    prm.declare_entry("Young's modulus", "73e9", Patterns::Double(0.));
    prm.declare_entry("Law", "elastic", Patterns::Selection("elastic|J2"));
    prm.leave_subsection();
    prm.leave_subsection();
    prm.enter_subsection("Time");
    prm.declare_entry("End time", "1", Patterns::Double());
    prm.leave_subsection();
  }



  /** The message of the error, or an empty text without one. */
  template <typename Function>
  std::string
  message_of(const Function &function)
  {
    try
      {
        function();
      }
    catch (const InputError &error)
      {
        return error.what();
      }
    return "";
  }



  /** Writes the text to prm/a.prm and reads and applies it. */
  std::string
  message_for(const std::string &text)
  {
    write_file("prm/a.prm", text);
    return message_of([]() {
      ParameterHandler prm;
      declare(prm);
      ParameterFile::read("prm/a.prm").apply(prm);
    });
  }



  std::string
  message_of_override(const std::string &assignment)
  {
    write_file("prm/a.prm", "set Title = x\n");
    return message_of([&]() {
      ParameterHandler prm;
      declare(prm);
      ParameterFile file = ParameterFile::read("prm/a.prm");
      file.override_entry(assignment);
      file.apply(prm);
    });
  }



  const std::vector<std::string> material = {"Body beam", "Material"};
} // namespace



BOOST_AUTO_TEST_CASE(values_reach_the_handler)
{
  write_file("prm/a.prm",
             "set Title = A   beam # not this\n"
             "# set Title = nor this \\\n"
             "SUBSECTION Body  beam\r\n"
             "\tset\tRefinements\t= 3\n"
             "  subsection Material\n"
             "    set Young's modulus = 2.1e11\n"
             "  end\n"
             "END\n"
             "set Bodies = beam, \\   # the first\n"
             "             floor, \\  # the second\n"
             "             wall\n");
  ParameterHandler prm;
  declare(prm);
  const ParameterFile file = ParameterFile::read("prm/a.prm");
  file.apply(prm);
  BOOST_TEST(prm.get("Title") == "A beam");
  BOOST_TEST(prm.get("Bodies") == "beam, floor, wall");
  BOOST_TEST(prm.get_integer({"Body beam"}, "Refinements") == 3);
  BOOST_TEST(prm.get_double(material, "Young's modulus") == 2.1e11);
  BOOST_TEST(prm.get(material, "Law") == "elastic");
  BOOST_TEST(file.get("Body beam/Material/Young's modulus", "0") == "2.1e11");
  BOOST_TEST(file.get("Body beam/Material/Law", "none") == "none");
  BOOST_TEST(file.where("Bodies") == "prm/a.prm:9");
}

BOOST_AUTO_TEST_CASE(own_listing_reads_back)
{
  ParameterHandler prm;
  declare(prm);
  prm.set("Bodies", "beam");
  std::ofstream listing("prm/listing.prm");
  prm.print_parameters(listing, ParameterHandler::Text);
  listing.close();
  ParameterHandler again;
  declare(again);
  ParameterFile::read("prm/listing.prm").apply(again);
  BOOST_TEST((again == prm));
}

BOOST_AUTO_TEST_CASE(includes_and_overrides)
{
  std::filesystem::create_directories("prm/common");
  write_file("prm/common/long.prm",
             "set Title = long\n"
             "include time.prm\n"
             "subsection Body beam\n  include material.inc\nend\n");
  write_file("prm/common/time.prm",
             "subsection Time\n  set End time = 2\nend\n");
  write_file("prm/common/material.inc",
             "subsection Material\n  set Law = J2\nend\n");
  write_file("prm/short.prm",
             "include common/long.prm\n"
             "subsection Time\n  set End time = 3\nend\n");
  ParameterFile file = ParameterFile::read("prm/short.prm");
  BOOST_TEST(file.where("Time/End time") == "prm/short.prm:3");
  BOOST_TEST(file.where("Title") == "prm/common/long.prm:1");
  BOOST_TEST(file.where("Body beam/Material/Law") ==
             "prm/common/material.inc:2");
  BOOST_TEST(file.where("Body beam/Material") == "prm/common/material.inc:1");
  BOOST_TEST(file.where("Bodies") == "default");
  BOOST_TEST(file.path() == "prm/short.prm");
  BOOST_TEST(file.directory() == "prm");

  file.override_entry("Body beam / Material/Young's modulus = 5");
  file.override_entry("Title=a=b");
  ParameterHandler prm;
  declare(prm);
  file.apply(prm);
  BOOST_TEST(prm.get("Title") == "a=b");
  BOOST_TEST(prm.get_double({"Time"}, "End time") == 3.);
  BOOST_TEST(prm.get(material, "Law") == "J2");
  BOOST_TEST(prm.get_double(material, "Young's modulus") == 5.);
  BOOST_TEST(file.where("Title") == "--set");

  write_file("alone.prm", "set Title = alone\n");
  BOOST_TEST(ParameterFile::read("alone.prm").directory() == ".");
}

BOOST_AUTO_TEST_CASE(unknown_names)
{
  BOOST_TEST(message_for("subsection Body beam\n  subsection Material\n"
                         "    set Youngs modulus = 1\n  end\nend\n") ==
             "prm/a.prm:3: in \"Body beam / Material\": unknown entry "
             "\"Youngs modulus\". Did you mean \"Young's modulus\"? "
             "Allowed entries here: Young's modulus, Law.");
  BOOST_TEST(message_for("set End time = 1\n") ==
             "prm/a.prm:1: unknown entry \"End time\". It belongs to "
             "\"Time\". Allowed entries here: Title, Bodies.");
  BOOST_TEST(message_for("subsection Time\n  set Title = x\nend\n") ==
             "prm/a.prm:2: in \"Time\": unknown entry \"Title\". It belongs "
             "to the top of the file, outside any subsection. Allowed "
             "entries here: End time.");
  BOOST_TEST(message_for("set Time = 1\n") ==
             "prm/a.prm:1: unknown entry \"Time\". It is a subsection: write "
             "\"subsection Time\", its entries, and \"end\". Allowed entries "
             "here: Title, Bodies.");
  BOOST_TEST(message_for("subsection Body beam\n  subsection Materials\n"
                         "    set Law = J2\n  end\nend\n") ==
             "prm/a.prm:2: in \"Body beam\": unknown subsection "
             "\"Materials\". Did you mean \"Material\"? Allowed subsections "
             "here: Material.");
  BOOST_TEST(message_for("subsection Wall\nend\n") ==
             "prm/a.prm:1: unknown subsection \"Wall\". Allowed subsections "
             "here: Body beam, Time.");
  BOOST_TEST(message_for("subsection Title\nend\n") ==
             "prm/a.prm:1: unknown subsection \"Title\". It is an entry: "
             "write \"set Title = ...\". Allowed subsections here: "
             "Body beam, Time.");
  BOOST_TEST(message_for("subsection Time\n  subsection Steps\n  end\nend\n") ==
             "prm/a.prm:2: in \"Time\": unknown subsection \"Steps\". There "
             "are no subsections here.");
}

BOOST_AUTO_TEST_CASE(wrong_values)
{
  const std::string begin = "subsection Body beam\n  subsection Material\n";
  const std::string end   = "  end\nend\n";
  BOOST_TEST(message_for(begin + "    set Young's modulus = -1\n" + end) ==
             "prm/a.prm:3: in \"Body beam / Material\": entry \"Young's "
             "modulus\" cannot be \"-1\". Allowed: a number >= 0.");
  BOOST_TEST(message_for(begin + "    set Young's modulus =\n" + end) ==
             "prm/a.prm:3: in \"Body beam / Material\": entry \"Young's "
             "modulus\" has no value. Allowed: a number >= 0.");
  BOOST_TEST(message_for(begin + "    set Law = elastc\n" + end) ==
             "prm/a.prm:3: in \"Body beam / Material\": entry \"Law\" cannot "
             "be \"elastc\". Did you mean \"elastic\"? Allowed: one of "
             "elastic, J2.");
  BOOST_TEST(message_for("set Bodies =\n") == "");
  BOOST_TEST(
    message_for("subsection Time\n  set End time = soon\nend\n"
                "set Titel = x\n") ==
    "prm/a.prm:2: in \"Time\": entry \"End time\" cannot be "
    "\"soon\". Allowed: a number. The expression \"soon\" has the "
    "unknown name \"soon\". Did you mean \"sign\"? Allowed are numbers, the constants pi "
    "(more of them: entry Constants), and functions such as sqrt, "
    "sin and max.\n"
    "prm/a.prm:4: unknown entry \"Titel\". Did you mean \"Title\"? "
    "Allowed entries here: Title, Bodies.");
}

BOOST_AUTO_TEST_CASE(expressions_in_numbers)
{
  write_file("prm/a.prm",
             "set Constants = h = 0.1, n = 3, b = 2*h\n"
             "subsection Body beam\n"
             "  set Refinements = n - 1\n"
             "  subsection Material\n    set Young's modulus = b\n  end\n"
             "end\n"
             "subsection Time\n  set End time = 12e-3\nend\n");
  ParameterFile    file = ParameterFile::read("prm/a.prm");
  ParameterHandler prm;
  prm.declare_entry("Constants", "", Patterns::Anything());
  declare(prm);
  file.apply(prm);
  BOOST_TEST(prm.get(material, "Young's modulus") == "0.2");
  BOOST_TEST(prm.get({"Body beam"}, "Refinements") == "2");
  BOOST_TEST(prm.get({"Time"}, "End time") == "12e-3"); // as it was written

  file.override_entry("Constants=h = 1e-7, n = 0.3/0.1, b = -1");
  BOOST_TEST(message_of([&] { file.apply(prm); }) ==
             "prm/a.prm:5: in \"Body beam / Material\": entry \"Young's "
             "modulus\" cannot be \"b\". Allowed: a number >= 0. Its value "
             "is -1.");
  BOOST_TEST(prm.get({"Body beam"}, "Refinements") == "2");
}

BOOST_AUTO_TEST_CASE(wrong_expressions)
{
  const auto message = [](const std::string &assignment) {
    write_file("prm/a.prm", "set Constants = height = 0.1\n");
    ParameterFile file = ParameterFile::read("prm/a.prm");
    file.override_entry(assignment);
    return message_of([&] {
      ParameterHandler prm;
      prm.declare_entry("Constants", "", Patterns::Anything());
      declare(prm);
      file.apply(prm);
    });
  };
  BOOST_TEST(message("Time/End time=2*hieght") ==
             "--set: in \"Time\": entry \"End time\" cannot be "
             "\"2*hieght\". Allowed: a number. The expression \"2*hieght\" "
             "has the unknown name \"hieght\". Did you mean \"height\"? "
             "Allowed are numbers, the constants height, pi (more of them: "
             "entry Constants), and functions such as sqrt, sin and max.");
  BOOST_TEST(message("Body beam/Refinements=25*height") ==
             "--set: in \"Body beam\": entry \"Refinements\" cannot be "
             "\"25*height\". Allowed: a whole number >= 0. The expression "
             "\"25*height\" is 2.5, but a whole number is expected.");
  BOOST_TEST(
    message("Constants=h = 1/0")
      .rfind("--set: Constants: found \"1/0\", expected a number", 0) == 0);
}

BOOST_AUTO_TEST_CASE(wrong_syntax)
{
  BOOST_TEST(message_for("set Title = x\nend\n") ==
             "prm/a.prm:2: \"end\" without a subsection to close. Remove it, "
             "or add the \"subsection\" line.");
  BOOST_TEST(message_for("\nsubsection Body beam\n  subsection Material\n"
                         "  end\n") ==
             "prm/a.prm:2: subsection \"Body beam\" is not closed. An "
             "\"end\" is missing, in it or in a subsection inside it.");
  BOOST_TEST(message_for("set Title x\n") ==
             "prm/a.prm:1: \"set Title x\" has no \"=\". Write: set NAME = "
             "VALUE.");
  BOOST_TEST(message_for("set = x\n") ==
             "prm/a.prm:1: \"set\" without a name before the \"=\". Write: "
             "set NAME = VALUE.");
  BOOST_TEST(message_for("subsection # Time\n") ==
             "prm/a.prm:1: \"subsection\" without a name.");
  BOOST_TEST(message_for("include\n") ==
             "prm/a.prm:1: \"include\" without a file name.");
  BOOST_TEST(message_for("Title = x\n") ==
             "prm/a.prm:1: cannot understand \"Title = x\". A line is one "
             "of: set NAME = VALUE, subsection NAME, end, include FILE, # "
             "comment.");
  BOOST_TEST(message_for("subsection Time\nend Time\n") ==
             "prm/a.prm:2: cannot understand \"end Time\". A line is one of: "
             "set NAME = VALUE, subsection NAME, end, include FILE, # "
             "comment.");
  BOOST_TEST(message_for("\nset Title = x \\\n") ==
             "prm/a.prm:2: the backslash promises another line, but the file "
             "ends. Remove the backslash.");
}

BOOST_AUTO_TEST_CASE(wrong_files)
{
  write_file("prm/beam.prm", "");
  BOOST_TEST(message_of([]() { ParameterFile::read("prm/baem.prm"); }) ==
             "\"prm/baem.prm\" does not exist. Did you mean "
             "\"prm/beam.prm\"?");
  BOOST_TEST(message_of([]() { ParameterFile::read("nowhere/beam.prm"); }) ==
             "\"nowhere/beam.prm\" does not exist.");
  BOOST_TEST(message_of([]() { ParameterFile::read("prm"); }) ==
             "\"prm\" is a folder. A file is expected.");
  BOOST_TEST(message_for("\ninclude sub/x.prm\n") ==
             "prm/a.prm:2: \"prm/sub/x.prm\" does not exist.");
  write_file("prm/b.prm", "# b\ninclude a.prm\n");
  BOOST_TEST(message_for("include ../prm/b.prm\n") ==
             "prm/b.prm:2: the file includes itself: prm/a.prm -> prm/b.prm "
             "-> prm/a.prm.");
  write_file("prm/b.prm", "end\n");
  BOOST_TEST(message_for("subsection Time\n  include b.prm\nend\n") ==
             "prm/b.prm:1: \"end\" without a subsection to close. Remove it, "
             "or add the \"subsection\" line.");
  // The super user may read everything.
  if (geteuid() != 0)
    {
      std::filesystem::permissions("prm/beam.prm",
                                   std::filesystem::perms::none);
      BOOST_TEST(message_of([]() { ParameterFile::read("prm/beam.prm"); }) ==
                 "\"prm/beam.prm\" cannot be read. Check its "
                 "permissions.");
    }
}

BOOST_AUTO_TEST_CASE(wrong_overrides)
{
  BOOST_TEST(message_of_override("Title") ==
             "--set: \"Title\" has no \"=\". Write: --set "
             "\"Section/Entry=value\".");
  BOOST_TEST(message_of_override("Time/=1") ==
             "--set: \"Time/=1\" has an empty name before the \"=\". Write: "
             "--set \"Section/Entry=value\".");
  BOOST_TEST(message_of_override("=1") ==
             "--set: \"=1\" has an empty name before the \"=\". Write: "
             "--set \"Section/Entry=value\".");
  BOOST_TEST(message_of_override("Time/End=1") ==
             "--set: in \"Time\": unknown entry \"End\". Allowed entries "
             "here: End time.");
  BOOST_TEST(message_of_override("Tme/End time=1") ==
             "--set: unknown subsection \"Tme\". Did you mean \"Time\"? "
             "Allowed subsections here: Body beam, Time.");
  BOOST_TEST(message_of_override("Time/End time=x") ==
             "--set: in \"Time\": entry \"End time\" cannot be \"x\". "
             "Allowed: a number. The expression \"x\" depends on x, but it "
             "may depend on no variable.");
}

BOOST_AUTO_TEST_SUITE_END()
