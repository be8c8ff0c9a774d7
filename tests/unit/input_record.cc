#include <signorini/input/input_error.h>
#include <signorini/run/input_record.h>

#include <deal.II/base/parameter_handler.h>

#include <boost/test/unit_test.hpp>

BOOST_AUTO_TEST_SUITE(input_record)

using namespace Signorini;

namespace
{
  std::string
  error_of(const std::vector<InputEntry> &old_entries,
           const std::vector<InputEntry> &entries)
  {
    try
      {
        refuse_changed_input(old_entries, entries);
      }
    catch (const InputError &error)
      {
        return error.what();
      }
    return "";
  }
} // namespace



BOOST_AUTO_TEST_CASE(every_entry_with_its_value)
{
  dealii::ParameterHandler prm;
  prm.declare_entry("Title", "");
  prm.enter_subsection("Body a.b");
  prm.declare_entry("Mesh", "block");
  prm.enter_subsection("Material");
  prm.declare_entry("Young's modulus", "1");
  prm.leave_subsection();
  prm.set("Mesh", std::string("file x.msh"));
  prm.leave_subsection();
  const auto entries = input_entries(prm);
  BOOST_TEST(entries.size() == 3u);
  BOOST_TEST(entries[0].path == "Title");
  BOOST_TEST(entries[0].value == "");
  BOOST_TEST(entries[1].path == "Body a.b / Mesh");
  BOOST_TEST(entries[1].value == "file x.msh");
  BOOST_TEST(entries[2].path == "Body a.b / Material / Young's modulus");
  BOOST_TEST(entries[2].value == "1");
}



BOOST_AUTO_TEST_CASE(what_may_change)
{
  for (const std::string path : {"Title",
                                 "Time / End time",
                                 "Time / Maximal step size",
                                 "Output / Directory",
                                 "Output / Time between fields",
                                 "Expected results / Checks"})
    BOOST_TEST(may_change_on_resume(path), path);
  for (const std::string path : {"Bodies",
                                 "Time / Step size",
                                 "Time / Scheme",
                                 "Output / Monitor",
                                 "Body Output / Material / Density"})
    BOOST_TEST(!may_change_on_resume(path), path);
}



BOOST_AUTO_TEST_CASE(differences_are_named)
{
  const std::vector<InputEntry> old_entries = {{"Time / End time", "1"},
                                               {"Bodies", "a"},
                                               {"Time / Scheme", "HHT"},
                                               {"Constants", ""}};
  std::vector<InputEntry>       entries     = old_entries;
  BOOST_TEST(error_of(old_entries, entries) == "");
  entries[0].value = "2";
  BOOST_TEST(error_of(old_entries, entries) == "");
  entries[1].value        = "b";
  entries[3].value        = "F = 1";
  const std::string error = error_of(old_entries, entries);
  BOOST_TEST(error.find("--resume: the input is not that of the checkpoint:\n"
                        "  Bodies: \"b\", in the checkpoint \"a\"\n"
                        "  Constants: \"F = 1\", in the checkpoint nothing\n"
                        "Only the End time") == 0u);
}

BOOST_AUTO_TEST_SUITE_END()
