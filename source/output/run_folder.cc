#include <signorini/input_error.h>
#include <signorini/output/checkpoint.h>
#include <signorini/output/run_folder.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <system_error>

namespace Signorini
{
  namespace
  {
    namespace fs = std::filesystem;

    [[noreturn]] void
    fail(const fs::path &folder, const std::string &reason)
    {
      throw InputError("The output folder '" + folder.string() +
                       "' cannot be used: " + reason +
                       ". Choose another one (Output / Directory, or "
                       "--output-directory), or change the rights or contents "
                       "of this one.");
    }

    bool
    is_written_by_us(const fs::path &file)
    {
      static const std::array<std::string, 8> endings = {{".vtu",
                                                          ".pvd",
                                                          ".csv",
                                                          ".log",
                                                          ".prm",
                                                          ".txt",
                                                          ".checkpoint",
                                                          ".displacement"}};
      return std::find(endings.begin(),
                       endings.end(),
                       file.extension().string()) != endings.end();
    }

    // True when the folder is there and empty, or was created just now.
    bool
    is_free(const fs::path &folder)
    {
      std::error_code error;
      if (fs::create_directories(folder, error))
        return true;
      if (error)
        fail(folder, error.message());
      const bool empty = fs::is_empty(folder, error);
      if (error)
        fail(folder, error.message());
      return empty;
    }

    void
    remove_old_results(const fs::path &folder, const fs::path &parameter_file)
    {
      std::error_code error;
      for (const auto &entry : fs::directory_iterator(folder, error))
        {
          if (!entry.is_regular_file() || !is_written_by_us(entry.path()))
            continue;
          std::error_code not_there;
          if (fs::equivalent(entry.path(), parameter_file, not_there))
            fail(folder,
                 "overwriting it would remove the parameter file '" +
                   parameter_file.string() + "' itself");
          fs::remove(entry.path(), error);
          if (error)
            fail(folder,
                 "'" + entry.path().string() +
                   "' cannot be removed: " + error.message());
        }
      if (error)
        fail(folder, error.message());
    }

    std::string
    name_of_run(const std::string &parameter_file)
    {
      const std::string name = fs::path(parameter_file).stem().string();
      if (name.empty())
        throw InputError("The name of the parameter file, '" + parameter_file +
                         "', does not name a run. Use a name like beam.prm.");
      return name;
    }

    // NAME, NAME-2, NAME-3, ...
    fs::path
    numbered_folder(const std::string &base,
                    const std::string &name,
                    const unsigned int number)
    {
      return fs::path(base) /
             (number == 1 ? name : name + "-" + std::to_string(number));
    }

    // Rights alone do not tell: the disk may be full or mounted read-only.
    void
    try_to_write(const fs::path &folder)
    {
      const fs::path probe = folder / ".signorini-probe";
      std::FILE     *file  = std::fopen(probe.c_str(), "w");
      if (file == nullptr)
        fail(folder, std::strerror(errno));
      const bool written = std::fputc('x', file) != EOF;
      const bool closed  = std::fclose(file) == 0;
      const int  reason  = errno;

      std::error_code ignored;
      fs::remove(probe, ignored);
      if (!written || !closed)
        fail(folder, std::strerror(reason));
    }
  } // namespace



  std::string
  create_run_folder(const std::string &base,
                    const std::string &parameter_file,
                    const bool         overwrite,
                    const std::string &needed)
  {
    const std::string name   = name_of_run(parameter_file);
    fs::path          folder = numbered_folder(base, name, 1);
    if (overwrite)
      {
        std::error_code not_there;
        if (fs::equivalent(folder, needed, not_there))
          fail(folder, "it is the folder of the global run that is needed");
        if (!is_free(folder))
          remove_old_results(folder, parameter_file);
      }
    else
      for (unsigned int number = 2; !is_free(folder); ++number)
        folder = numbered_folder(base, name, number);

    try_to_write(folder);
    return folder.string();
  }



  std::string
  find_run_folder(const std::string &base, const std::string &parameter_file)
  {
    const std::string  name = name_of_run(parameter_file);
    std::string        newest;
    fs::file_time_type newest_time;
    for (unsigned int number = 1;; ++number)
      {
        const fs::path folder = numbered_folder(base, name, number);
        if (!fs::is_directory(folder))
          break;
        const auto time = checkpoint_time(folder.string());
        if (time && (newest.empty() || *time > newest_time))
          {
            newest      = folder.string();
            newest_time = *time;
          }
      }
    if (newest.empty())
      throw InputError(
        "--resume: there is no checkpoint of " + name + " below '" + base +
        "'. Start the run anew without --resume, or name its folder with "
        "--resume-from DIR. Output / Minutes between checkpoints tells how often "
        "one is written.");
    return newest;
  }
} // namespace Signorini
