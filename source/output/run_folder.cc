#include <signorini/input/input_error.h>
#include <signorini/output/checkpoint.h>
#include <signorini/output/run_folder.h>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <set>
#include <system_error>
#include <utility>

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

    // On it stand the names of the files that runs have written here.
    const char *const list_name = ".signorini-files";

    std::set<std::string>
    listed_files(const fs::path &folder)
    {
      std::set<std::string> names;
      std::ifstream         list(folder / list_name);
      for (std::string name; std::getline(list, name);)
        // No list leads out of its folder.
        if (fs::path(name).filename() == name)
          names.insert(name);
      return names;
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
    remove_file(const fs::path &folder, const fs::path &file)
    {
      std::error_code error;
      if (!fs::is_regular_file(file, error))
        return;
      fs::remove(file, error);
      if (error)
        fail(folder,
             "'" + file.string() + "' cannot be removed: " + error.message());
    }

    void
    remove_old_results(const fs::path &folder, const fs::path &parameter_file)
    {
      const auto names = listed_files(folder);
      for (const std::string &name : names)
        {
          std::error_code not_there;
          if (fs::equivalent(folder / name, parameter_file, not_there))
            fail(folder,
                 "overwriting it would remove the parameter file '" +
                   parameter_file.string() + "' itself");
        }
      for (const std::string &name : names)
        {
          remove_file(folder, folder / name);
          remove_file(folder, folder / (name + being_written));
        }
      remove_file(folder, folder / list_name);
    }

    // Of the folder, locked; negative if another run has locked it. Where a
    // file system has no locks the run goes on without.
    int
    locked(const fs::path &folder)
    {
      const int descriptor =
        ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
      if (descriptor < 0)
        fail(folder, std::strerror(errno));
      if (::flock(descriptor, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK)
        return descriptor;
      ::close(descriptor);
      return -1;
    }

    [[noreturn]] void
    fail_in_use(const fs::path &folder)
    {
      fail(folder, "another run is writing to it at this moment");
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



  RunFolder
  RunFolder::create(const std::string &base,
                    const std::string &parameter_file,
                    const bool         overwrite,
                    const std::string &needed)
  {
    const std::string name = name_of_run(parameter_file);
    if (overwrite)
      {
        const fs::path  path = numbered_folder(base, name, 1);
        std::error_code not_there;
        if (fs::equivalent(path, needed, not_there))
          fail(path, "it is the folder of the global run that is needed");
        const bool was_free = is_free(path);
        RunFolder  folder   = open(path.string());
        if (!was_free)
          remove_old_results(path, parameter_file);
        try_to_write(path);
        return folder;
      }
    for (unsigned int number = 1;; ++number)
      {
        const fs::path path = numbered_folder(base, name, number);
        if (!is_free(path))
          continue;
        const int descriptor = locked(path);
        if (descriptor < 0)
          continue;
        RunFolder folder(path.string(), descriptor);
        // Another run may have come and gone before it was locked.
        if (!is_free(path))
          continue;
        try_to_write(path);
        return folder;
      }
  }



  RunFolder
  RunFolder::open(const std::string &path)
  {
    const int descriptor = locked(path);
    if (descriptor < 0)
      fail_in_use(path);
    return RunFolder(path, descriptor);
  }



  RunFolder::RunFolder(const std::string &path, const int descriptor)
    : path_(path)
    , descriptor_(descriptor)
  {}



  RunFolder::RunFolder(RunFolder &&other) noexcept
    : path_(std::move(other.path_))
    , descriptor_(std::exchange(other.descriptor_, -1))
  {}



  RunFolder::~RunFolder()
  {
    if (descriptor_ >= 0)
      ::close(descriptor_); // and with it the lock goes
  }



  const std::string &
  result_file(const std::string &path)
  {
    const fs::path    file   = path;
    const fs::path    folder = file.parent_path();
    const std::string name   = file.filename().string();
    std::error_code   error;
    if (fs::is_regular_file(file, error))
      {
        if (listed_files(folder).count(name) == 0)
          fail(folder,
               "'" + name +
                 "' in it would be overwritten, which no run has written "
                 "(its files are those listed in " +
                 list_name + ")");
        return path;
      }
    std::ofstream list(folder / list_name, std::ios::app);
    list << name << '\n' << std::flush;
    if (!list)
      fail(folder, std::string(list_name) + " in it cannot be written");
    return path;
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
