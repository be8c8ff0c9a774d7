#include <signorini/input/input_error.h>
#include <signorini/input/regular_file.h>

#include <filesystem>

namespace Signorini
{
  namespace fs = std::filesystem;

  void
  require_regular_file(const std::string &path, const std::uintmax_t largest)
  {
    std::error_code       error;
    const fs::file_status status = fs::status(path, error);
    if (!fs::exists(status))
      return;
    const std::string name = "\"" + path + "\"";
    if (fs::is_directory(status))
      throw InputError(name + " is a folder. A file is expected.");
    if (!fs::is_regular_file(status))
      throw InputError(name + " is a pipe or a device. A file on a disk is "
                              "expected.");
    const std::uintmax_t size = fs::file_size(path, error);
    if (!error && size > largest)
      throw InputError(name + " has " + std::to_string(size) +
                       " bytes, allowed are " + std::to_string(largest) +
                       ". Is it the right file?");
  }
} // namespace Signorini
