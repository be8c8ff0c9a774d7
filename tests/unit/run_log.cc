#include <signorini/input/input_error.h>
#include <signorini/output/log.h>

#include <boost/test/unit_test.hpp>

#include <chrono>
#include <sstream>
#include <thread>

#include "temporary_folder.h"

BOOST_AUTO_TEST_SUITE(run_log)

using Signorini::Log;

namespace
{
  Log::Settings
  settings(const bool   is_terminal,
           const double refresh_interval,
           const double line_interval)
  {
    Log::Settings result;
    result.is_terminal      = is_terminal;
    result.refresh_interval = refresh_interval;
    result.line_interval    = line_interval;
    return result;
  }

  constexpr double never = 1e6;
} // namespace



BOOST_AUTO_TEST_CASE(lines_go_to_both_and_at_once)
{
  const TemporaryFolder folder;
  std::ostringstream    console;
  Log log(folder.file("run.log"), console, settings(false, 0., 0.));
  log.line("one");
  log.detail("two");
  // Before the end of the object: a killed run has its log.
  BOOST_TEST(console.str() == "one\n");
  BOOST_TEST(read_file(folder.file("run.log")) == "one\ntwo\n");
}

BOOST_AUTO_TEST_CASE(a_file_goes_on)
{
  const TemporaryFolder folder;
  std::ostringstream    console;
  Log::Settings         appending = settings(false, 0., 0.);
  appending.append                = true;
  Log(folder.file("run.log"), console, appending).line("one");
  Log(folder.file("run.log"), console, appending).line("two");
  BOOST_TEST(read_file(folder.file("run.log")) == "one\ntwo\n");
  Log(folder.file("run.log"), console, settings(false, 0., 0.)).line("anew");
  BOOST_TEST(read_file(folder.file("run.log")) == "anew\n");
}

BOOST_AUTO_TEST_CASE(progress_overwrites_itself_on_a_terminal)
{
  const TemporaryFolder folder;
  std::ostringstream    console;
  {
    Log log(folder.file("run.log"), console, settings(true, 0., never));
    log.progress("step 1");
    log.progress("step 2");
    log.line("done");
    log.progress("step 3");
  }
  BOOST_TEST(console.str() == "\r\x1b[Kstep 1\r\x1b[Kstep 2"
                              "\r\x1b[Kdone\n\r\x1b[Kstep 3\n");
  BOOST_TEST(read_file(folder.file("run.log")) == "step 1\ndone\n");
}

BOOST_AUTO_TEST_CASE(progress_is_an_ordinary_line_elsewhere)
{
  std::ostringstream console;
  Log                log("", console, settings(false, 0., never));
  BOOST_TEST(log.progress_is_due());
  log.progress("step 1");
  BOOST_TEST(!log.progress_is_due());
  log.progress("step 2");
  log.final_progress("step 3");
  BOOST_TEST(console.str() == "step 1\nstep 3\n");
}

BOOST_AUTO_TEST_CASE(progress_returns_after_the_interval)
{
  std::ostringstream console;
  Log                log("", console, settings(true, 0.02, never));
  log.progress("a");
  log.progress("b");
  std::this_thread::sleep_for(std::chrono::milliseconds(25));
  BOOST_TEST(log.progress_is_due());
  log.progress("c");
  BOOST_TEST(console.str() == "\r\x1b[Ka\r\x1b[Kc");
}

BOOST_AUTO_TEST_CASE(a_full_disk_is_said_once)
{
  std::ostringstream console;
  Log                log("/dev/full", console, settings(false, 0., 0.));
  log.line("one");
  log.line("two");
  const std::string text = console.str();
  BOOST_TEST(text.find("one\nThe log file '/dev/full' cannot be written") == 0);
  BOOST_TEST(text.find("two\n") != std::string::npos);
  BOOST_TEST(text.find("cannot be") == text.rfind("cannot be"));
}

BOOST_AUTO_TEST_CASE(a_file_that_cannot_be_made)
{
  std::ostringstream console;
  BOOST_CHECK_THROW(Log("/nowhere/run.log", console, Log::Settings()),
                    Signorini::InputError);
}

BOOST_AUTO_TEST_SUITE_END()
