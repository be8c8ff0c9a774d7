#ifndef signorini_output_run_folder_h
#define signorini_output_run_folder_h

#include <string>

namespace Signorini
{
  /**
   * The folder that a run writes to, kept from other runs as long as the object
   * is there (flock(2)). The files that runs have written stand on a list in
   * it, .signorini-files, so that nothing else is ever overwritten or removed.
   */
  class RunFolder
  {
  public:
    /**
     * Creates base / NAME, where NAME is the name of the parameter file without
     * its folder and ending. A folder that is not empty, or in use, makes way
     * for NAME-2, NAME-3, ...
     *
     * With @p overwrite the folder NAME itself is used, and the files on its
     * list are removed first.
     *
     * @throws InputError when the folder cannot be created, cleared or written
     * to, with the path and the reason of the system; when overwriting would
     * remove @p parameter_file itself or what is in the folder @p needed; and
     * when another run uses the folder.
     */
    static RunFolder
    create(const std::string &base,
           const std::string &parameter_file,
           const bool         overwrite = false,
           const std::string &needed    = "");

    /** The folder of a run that goes on. @throws InputError as create(). */
    static RunFolder
    open(const std::string &path);

    RunFolder(RunFolder &&other) noexcept;
    RunFolder(const RunFolder &) = delete;
    RunFolder &
    operator=(const RunFolder &) = delete;
    ~RunFolder();

    const std::string &
    path() const
    {
      return path_;
    }

  private:
    RunFolder(const std::string &path, const int descriptor);

    std::string path_;
    int         descriptor_; // of the folder; negative: none
  };

  /** Ends the name of a file that takes the place of another one when it is
   * whole. */
  constexpr const char *being_written = ".new";

  /**
   * Puts a file that is going to be written on the list of its folder.
   * @return the path itself
   * @throws InputError when there is a file of this name already that is not
   * on the list: it is somebody else's. Links and devices are written to.
   */
  const std::string &
  result_file(const std::string &path);

  /**
   * The folder of an earlier run of this parameter file: of NAME, NAME-2, ...
   * below base the one whose checkpoint is the newest.
   * @throws InputError when none of them holds a checkpoint.
   */
  std::string
  find_run_folder(const std::string &base, const std::string &parameter_file);
} // namespace Signorini

#endif
