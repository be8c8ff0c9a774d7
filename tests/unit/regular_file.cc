#include <signorini/input/input_error.h>
#include <signorini/input/regular_file.h>

#include <boost/test/unit_test.hpp>

#include <sys/stat.h>

#include <filesystem>
#include <string>

#include "temporary_folder.h"

BOOST_AUTO_TEST_SUITE(regular_file)

using namespace Signorini;

namespace
{
  std::string
  message(const std::string &path, const std::uintmax_t largest = 10)
  {
    try
      {
        require_regular_file(path, largest);
      }
    catch (const InputError &error)
      {
        return error.what();
      }
    return "";
  }
} // namespace



BOOST_AUTO_TEST_CASE(what_can_be_read)
{
  const TemporaryFolder folder;
  const std::string     file = folder.file("a.prm");
  BOOST_TEST(message(file) == ""); // that it is missing others say
  write_file(file, "0123456789");
  BOOST_TEST(message(file) == "");
  write_file(file, "0123456789a");
  BOOST_TEST(message(file) == "\"" + file +
                                "\" has 11 bytes, allowed are 10. Is it the "
                                "right file?");
}

BOOST_AUTO_TEST_CASE(what_would_never_end)
{
  const TemporaryFolder folder;
  const std::string     pipe = folder.file("pipe");
  BOOST_REQUIRE(mkfifo(pipe.c_str(), 0600) == 0);
  for (const std::string &path : {pipe, std::string("/dev/zero")})
    BOOST_TEST(message(path) ==
               "\"" + path +
                 "\" is a pipe or a device. A file on a disk is expected.");
  BOOST_TEST(message(folder.path.string()) ==
             "\"" + folder.path.string() +
               "\" is a folder. A file is expected.");
}

BOOST_AUTO_TEST_SUITE_END()
