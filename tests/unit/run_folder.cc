#include <signorini/input_error.h>
#include <signorini/output/run_folder.h>

#include <boost/test/unit_test.hpp>

#include "temporary_folder.h"

using Signorini::create_run_folder;
using Signorini::find_run_folder;
using Signorini::InputError;

BOOST_AUTO_TEST_SUITE(run_folder)

BOOST_AUTO_TEST_CASE(name_of_the_parameter_file)
{
  const TemporaryFolder folder;
  const std::string     run =
    create_run_folder(folder.file("a/output"), "prm/beam.v2.prm");
  BOOST_TEST(run == folder.file("a/output/beam.v2"));
  BOOST_TEST(std::filesystem::is_directory(run));
  BOOST_TEST(std::filesystem::is_empty(run));
  // Still empty: the same folder again.
  BOOST_TEST(create_run_folder(folder.file("a/output"), "beam.v2.prm") == run);
}

BOOST_AUTO_TEST_CASE(earlier_runs_stay)
{
  const TemporaryFolder folder;
  for (const std::string expected : {"beam", "beam-2", "beam-3"})
    {
      const std::string run =
        create_run_folder(folder.path.string(), "beam.prm");
      BOOST_TEST(run == folder.file(expected));
      write_file(run + "/history.csv", expected);
    }
  BOOST_TEST(read_file(folder.file("beam/history.csv")) == "beam");
  BOOST_TEST(read_file(folder.file("beam-2/history.csv")) == "beam-2");
}

BOOST_AUTO_TEST_CASE(overwriting_removes_only_results)
{
  const TemporaryFolder folder;
  const std::string     run = folder.file("beam");
  std::filesystem::create_directories(run + "/kept");
  write_file(run + "/kept/history.csv", "");
  for (const std::string ending :
       {"vtu", "pvd", "csv", "log", "prm", "txt", "checkpoint", "displacement"})
    write_file(run + "/result." + ending, "old");
  write_file(run + "/notes.odt", "");
  write_file(run + "/csv", "");

  BOOST_TEST(create_run_folder(folder.path.string(), "beam.prm", true) == run);
  for (const std::string ending :
       {"vtu", "pvd", "csv", "log", "prm", "txt", "checkpoint", "displacement"})
    BOOST_TEST(!std::filesystem::exists(run + "/result." + ending));
  BOOST_TEST(std::filesystem::exists(run + "/kept/history.csv"));
  BOOST_TEST(std::filesystem::exists(run + "/notes.odt"));
  BOOST_TEST(std::filesystem::exists(run + "/csv"));
}

BOOST_AUTO_TEST_CASE(the_parameter_file_itself_is_never_removed)
{
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder.file("beam"));
  const std::string prm = folder.file("beam/beam.prm");
  write_file(prm, "set Title = beam");
  BOOST_CHECK_THROW(create_run_folder(folder.path.string(), prm, true),
                    InputError);
  BOOST_TEST(read_file(prm) == "set Title = beam");
}

// A submodel does not remove the results of its global run.
BOOST_AUTO_TEST_CASE(a_folder_that_is_needed_stays)
{
  const TemporaryFolder folder;
  const std::string     run = folder.file("beam");
  std::filesystem::create_directory(run);
  write_file(run + "/displacements.csv", "kept");
  BOOST_CHECK_THROW(
    create_run_folder(folder.path.string(), "beam.prm", true, run + "/."),
    InputError);
  BOOST_TEST(read_file(run + "/displacements.csv") == "kept");
  BOOST_TEST(create_run_folder(folder.path.string(),
                               "beam.prm",
                               true,
                               folder.file("other")) == run);
}

// Of several runs of one file, that which was saved last.
BOOST_AUTO_TEST_CASE(the_run_to_resume)
{
  const TemporaryFolder folder;
  const std::string     base = folder.path.string();
  BOOST_CHECK_EXCEPTION(find_run_folder(base, "prm/beam.prm"),
                        InputError,
                        [&](const InputError &error) {
                          return std::string(error.what())
                                   .find(
                                     "--resume: there is no checkpoint of beam "
                                     "below '" +
                                     base + "'.") == 0;
                        });
  for (const std::string name : {"beam", "beam-2", "beam-3"})
    std::filesystem::create_directory(folder.file(name));
  BOOST_CHECK_THROW(find_run_folder(base, "prm/beam.prm"), InputError);
  write_file(folder.file("beam-2/last.checkpoint"), "");
  BOOST_TEST(find_run_folder(base, "prm/beam.prm") == folder.file("beam-2"));
  write_file(folder.file("beam/previous.checkpoint"), "");
  std::filesystem::last_write_time(
    folder.file("beam-2/last.checkpoint"),
    std::filesystem::file_time_type::clock::now() - std::chrono::hours(1));
  BOOST_TEST(find_run_folder(base, "prm/beam.prm") == folder.file("beam"));
}

BOOST_AUTO_TEST_CASE(errors_name_the_folder_and_the_reason)
{
  const TemporaryFolder folder;
  write_file(folder.file("file"), "");
  const auto is_clear = [&](const InputError &error) {
    const std::string text = error.what();
    return text.find(folder.file("file")) != std::string::npos &&
           text.find("irectory") != std::string::npos;
  };
  // Below a file no folder can be; nor can one take the place of a file.
  BOOST_CHECK_EXCEPTION(create_run_folder(folder.file("file"), "beam.prm"),
                        InputError,
                        is_clear);
  BOOST_CHECK_EXCEPTION(create_run_folder(folder.path.string(), "file.prm"),
                        InputError,
                        is_clear);
  BOOST_CHECK_THROW(create_run_folder(folder.path.string(), "prm/"),
                    InputError);
}

BOOST_AUTO_TEST_SUITE_END()
