#include <signorini/input/input_error.h>
#include <signorini/output/checkpoint.h>
#include <signorini/output/run_folder.h>

#include <boost/test/unit_test.hpp>

#include <thread>

#include "contains.h"
#include "temporary_folder.h"

BOOST_AUTO_TEST_SUITE(checkpoint)

using namespace Signorini;

namespace
{
  Checkpoint
  example(const double time)
  {
    Checkpoint result;
    result.time     = time;
    result.step     = 7;
    result.input    = {{"Title", "a \"title\""}, {"Time / End time", "1"}};
    result.geometry = 4000000000u;
    result.run      = std::string("bytes\0of any\nkind\xff", 18);
    result.meshes   = "more";
    return result;
  }

  // Which checkpoint a folder gives, and the warnings about newer ones.
  std::pair<double, std::string>
  found(const TemporaryFolder &folder)
  {
    const FoundCheckpoint result = read_checkpoint(folder.path.string());
    std::string           text;
    for (const std::string &warning : result.warnings)
      text += warning;
    return {result.checkpoint.time, text};
  }

  std::string
  error_of(const TemporaryFolder &folder)
  {
    try
      {
        read_checkpoint(folder.path.string());
      }
    catch (const InputError &error)
      {
        return error.what();
      }
    return "";
  }
} // namespace



BOOST_AUTO_TEST_CASE(round_trip)
{
  const TemporaryFolder folder;
  write_checkpoint(folder.path.string(), example(0.1));
  const Checkpoint copy     = read_checkpoint(folder.path.string()).checkpoint;
  const Checkpoint original = example(0.1);
  BOOST_TEST(copy.time == original.time);
  BOOST_TEST(copy.step == original.step);
  BOOST_TEST(copy.geometry == original.geometry);
  BOOST_TEST((copy.run == original.run));
  BOOST_TEST(copy.meshes == original.meshes);
  BOOST_TEST(copy.input.size() == 2u);
  BOOST_TEST(copy.input[0].value == original.input[0].value);
  BOOST_TEST(copy.input[1].path == original.input[1].path);
}



BOOST_AUTO_TEST_CASE(two_generations)
{
  const TemporaryFolder folder;
  BOOST_TEST(!checkpoint_time(folder.path.string()).has_value());
  for (const double time : {1., 2., 3.})
    write_checkpoint(folder.path.string(), example(time));
  BOOST_TEST(checkpoint_time(folder.path.string()).has_value());
  BOOST_TEST(found(folder).first == 3.);
  BOOST_TEST(found(folder).second == "");
  std::filesystem::remove(folder.file("last.checkpoint"));
  BOOST_TEST(found(folder).first == 2.);
  BOOST_TEST(!std::filesystem::exists(folder.file("new.checkpoint")));
}



// Whatever byte is the last: never half a checkpoint, always the older one.
BOOST_AUTO_TEST_CASE(cut_short)
{
  const TemporaryFolder folder;
  write_checkpoint(folder.path.string(), example(1.));
  write_checkpoint(folder.path.string(), example(2.));
  const std::string whole = read_file(folder.file("last.checkpoint"));
  for (std::size_t n = 0; n < whole.size(); ++n)
    {
      write_file(folder.file("last.checkpoint"), whole.substr(0, n));
      const auto [time, warning] = found(folder);
      BOOST_TEST(time == 1.);
      BOOST_TEST(contains(warning, "last.checkpoint' is damaged: it "));
    }
  write_file(folder.file("last.checkpoint"), whole);
  BOOST_TEST(found(folder).first == 2.);
}



// Every byte of the data is guarded, and the sizes in the second line.
BOOST_AUTO_TEST_CASE(changed_bytes)
{
  const TemporaryFolder folder;
  write_checkpoint(folder.path.string(), example(1.));
  write_checkpoint(folder.path.string(), example(2.));
  const std::string whole = read_file(folder.file("last.checkpoint"));
  for (std::size_t n = whole.find("bytes "); n < whole.size(); ++n)
    {
      std::string changed = whole;
      changed[n]          = static_cast<char>(changed[n] ^ 1);
      write_file(folder.file("last.checkpoint"), changed);
      const double time = found(folder).first;
      // The words in the second line are only for people.
      if (n >= whole.find('\n', whole.find("bytes ")))
        BOOST_TEST(time == 1.);
    }
  write_file(folder.file("last.checkpoint"), whole + "x");
  BOOST_TEST(found(folder).first == 1.);
}



// A run may be killed between the two renamings, or while it writes.
BOOST_AUTO_TEST_CASE(killed_while_writing)
{
  const TemporaryFolder folder;
  write_checkpoint(folder.path.string(), example(1.));
  write_checkpoint(folder.path.string(), example(2.));
  write_file(folder.file("new.checkpoint"), "Signorini check");
  BOOST_TEST(found(folder).first == 2.);
  BOOST_TEST(found(folder).second == "");

  std::filesystem::rename(folder.file("last.checkpoint"),
                          folder.file("new.checkpoint"));
  BOOST_TEST(found(folder).first == 2.);
  BOOST_TEST(found(folder).second == "");
}



BOOST_AUTO_TEST_CASE(full_disk)
{
  const TemporaryFolder folder;
  write_checkpoint(folder.path.string(), example(1.));
  std::filesystem::create_symlink("/dev/full", folder.file("new.checkpoint"));
  BOOST_CHECK_EXCEPTION(write_checkpoint(folder.path.string(), example(2.)),
                        ComputationError,
                        [](const ComputationError &error) {
                          return contains(error.what(),
                                          "last.checkpoint' cannot be written: "
                                          "No space left on device.");
                        });
  BOOST_TEST(found(folder).first == 1.);
  BOOST_TEST(!std::filesystem::exists(folder.file("new.checkpoint")));
}



BOOST_AUTO_TEST_CASE(messages)
{
  const TemporaryFolder folder;
  BOOST_TEST(contains(error_of(folder), "There is no checkpoint in '"));

  write_file(result_file(folder.file("last.checkpoint")), "something else\n");
  BOOST_TEST(
    contains(error_of(folder),
             "is damaged: it does not begin like a checkpoint. There is no "
             "other one."));

  write_checkpoint(folder.path.string(), example(1.));
  std::string       text = read_file(folder.file("last.checkpoint"));
  const std::string old  = "version " + std::to_string(checkpoint_version);
  text.replace(text.find(old), old.size(), "version 99");
  write_file(folder.file("last.checkpoint"), text);
  BOOST_TEST(contains(error_of(folder), "is of version 99 (written by Sig"));
  BOOST_TEST(contains(error_of(folder), "reads " + old + ". Go on with the"));
}



BOOST_AUTO_TEST_CASE(clock)
{
  CheckpointClock off(0, 0.);
  BOOST_TEST(off.is_off());
  BOOST_TEST(!off.is_due());

  CheckpointClock by_steps(3, 0.);
  BOOST_TEST(!by_steps.is_off());
  for (unsigned int i = 0; i < 2; ++i)
    {
      BOOST_TEST(!by_steps.is_due());
      BOOST_TEST(!by_steps.is_due());
      BOOST_TEST(by_steps.is_due());
    }

  CheckpointClock by_time(0, 0.02 / 60.);
  BOOST_TEST(!by_time.is_off());
  std::this_thread::sleep_for(std::chrono::milliseconds(25));
  BOOST_TEST(by_time.is_due());
  CheckpointClock by_hours(0, 60.);
  BOOST_TEST(!by_hours.is_due());
}

BOOST_AUTO_TEST_SUITE_END()
