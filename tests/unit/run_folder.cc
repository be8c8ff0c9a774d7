#include <signorini/input/input_error.h>
#include <signorini/output/run_folder.h>

#include <boost/test/unit_test.hpp>

#include <functional>

#include "temporary_folder.h"

BOOST_AUTO_TEST_SUITE(run_folder)

using Signorini::find_run_folder;
using Signorini::InputError;
using Signorini::result_file;
using Signorini::RunFolder;

namespace
{
  std::string
  create_run_folder(const std::string &base,
                    const std::string &parameter_file,
                    const bool         overwrite = false,
                    const std::string &needed    = "")
  {
    return RunFolder::create(base, parameter_file, overwrite, needed).path();
  }

  // As a run writes.
  void
  write_result(const std::string &name, const std::string &text)
  {
    write_file(result_file(name), text);
  }

  auto
  has_text(const std::string &expected)
  {
    return [expected](const InputError &error) {
      BOOST_TEST_MESSAGE(error.what());
      return std::string(error.what()).find(expected) != std::string::npos;
    };
  }
} // namespace


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

// Not what has the ending of a result, nor what lies elsewhere.
BOOST_AUTO_TEST_CASE(overwriting_removes_only_what_runs_wrote)
{
  const TemporaryFolder folder;
  const std::string     run = folder.file("beam");
  std::filesystem::create_directories(run + "/kept");
  write_file(run + "/kept/history.csv", "mine");
  write_file(run + "/measured.csv", "mine");
  write_file(run + "/beam.prm", "mine");
  write_file(folder.file("elsewhere.csv"), "mine");
  for (const std::string name :
       {"history.csv", "beam_00000.vtu", "results.pvd"})
    write_result(run + "/" + name, "old");
  write_file(run + "/results.pvd.new", "half of it");
  write_file(run + "/.signorini-files",
             read_file(run + "/.signorini-files") +
               "../elsewhere.csv\nkept/history.csv\nkept\n");

  BOOST_TEST(create_run_folder(folder.path.string(), "beam.prm", true) == run);
  for (const std::string name :
       {"history.csv", "beam_00000.vtu", "results.pvd", "results.pvd.new"})
    BOOST_TEST(!std::filesystem::exists(run + "/" + name));
  for (const std::string name :
       {"kept/history.csv", "measured.csv", "beam.prm", "../elsewhere.csv"})
    BOOST_TEST(read_file(run + "/" + name) == "mine");
}

BOOST_AUTO_TEST_CASE(files_of_others_are_not_written_to)
{
  const TemporaryFolder folder;
  write_file(folder.file("history.csv"), "mine");
  BOOST_CHECK_EXCEPTION(result_file(folder.file("history.csv")),
                        InputError,
                        has_text("'history.csv' in it would be overwritten"));
  // One's own may be written to again.
  write_result(folder.file("run.log"), "a");
  write_result(folder.file("run.log"), "b");
  BOOST_TEST(read_file(folder.file("run.log")) == "b");
}

BOOST_AUTO_TEST_CASE(one_run_at_a_time)
{
  const TemporaryFolder folder;
  const std::string     base = folder.path.string();
  {
    // Nothing is written yet; the lock alone tells.
    const RunFolder first = RunFolder::create(base, "beam.prm");
    BOOST_TEST(first.path() == folder.file("beam"));
    BOOST_TEST(create_run_folder(base, "beam.prm") == folder.file("beam-2"));
    write_result(first.path() + "/history.csv", "new");
    for (const auto &use :
         {std::function<void()>(
            [&] { create_run_folder(base, "beam.prm", true); }),
          std::function<void()>([&] { RunFolder::open(first.path()); })})
      BOOST_CHECK_EXCEPTION(use(),
                            InputError,
                            has_text("another run is writing to it"));
    BOOST_TEST(read_file(first.path() + "/history.csv") == "new");
  }
  BOOST_TEST(RunFolder::open(folder.file("beam")).path() ==
             folder.file("beam"));
  BOOST_TEST(create_run_folder(base, "beam.prm", true) == folder.file("beam"));
}

BOOST_AUTO_TEST_CASE(the_parameter_file_itself_is_never_removed)
{
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder.file("beam"));
  const std::string prm = folder.file("beam/beam.prm");
  write_result(prm, "set Title = beam");
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
  write_result(run + "/displacements.csv", "kept");
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
