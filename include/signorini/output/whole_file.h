#ifndef signorini_output_whole_file_h
#define signorini_output_whole_file_h

#include <string>

namespace Signorini
{
  /**
   * Writes a file and waits until it is on disk, so that it is whole even
   * when the machine stops right after.
   * @throws std::system_error with the reason when it cannot be written.
   */
  void
  write_to_disk(const std::string &path, const std::string &content);
} // namespace Signorini

#endif
