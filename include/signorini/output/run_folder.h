#ifndef signorini_output_run_folder_h
#define signorini_output_run_folder_h

#include <string>

namespace Signorini
{
  /**
   * Create the folder that a run writes to: base / NAME, where NAME is the
   * name of the parameter file without its folder and ending. The results of
   * another run are never overwritten: a folder that exists and is not empty
   * makes way for NAME-2, NAME-3, ...
   *
   * With @p overwrite the folder NAME itself is used, and the files directly
   * in it that the program could have written (endings vtu, pvd, csv, log,
   * prm, txt, checkpoint, displacement) are removed first. Everything else in
   * it stays.
   *
   * @return The path of the folder. It exists and can be written to.
   * @throws InputError when the folder cannot be created, cleared or written
   * to, with the path and the reason of the system, and when overwriting
   * would remove @p parameter_file itself or what is in the folder @p needed.
   */
  std::string
  create_run_folder(const std::string &base,
                    const std::string &parameter_file,
                    const bool         overwrite = false,
                    const std::string &needed    = "");

  /**
   * The folder of an earlier run of this parameter file: of NAME, NAME-2, ...
   * below base the one whose checkpoint is the newest.
   * @throws InputError when none of them holds a checkpoint.
   */
  std::string
  find_run_folder(const std::string &base, const std::string &parameter_file);
} // namespace Signorini

#endif
