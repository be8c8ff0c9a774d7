#ifndef tests_unit_temporary_folder_h
#define tests_unit_temporary_folder_h

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>

/** A new empty folder that goes away with this object. */
class TemporaryFolder
{
public:
  TemporaryFolder()
  {
    std::string name =
      (std::filesystem::temp_directory_path() / "signorini-test-XXXXXX")
        .string();
    if (mkdtemp(name.data()) == nullptr)
      throw std::runtime_error("No temporary folder could be made.");
    path = name;
  }

  ~TemporaryFolder()
  {
    std::error_code ignored;
    std::filesystem::remove_all(path, ignored);
  }

  TemporaryFolder(const TemporaryFolder &) = delete;
  TemporaryFolder &
  operator=(const TemporaryFolder &) = delete;

  std::string
  file(const std::string &name) const
  {
    return (path / name).string();
  }

  std::filesystem::path path;
};

inline std::string
read_file(const std::string &name)
{
  const std::ifstream file(name, std::ios::binary);
  std::ostringstream  text;
  text << file.rdbuf();
  return text.str();
}

inline void
write_file(const std::string &name, const std::string &text)
{
  std::ofstream(name, std::ios::binary) << text;
}

#endif
