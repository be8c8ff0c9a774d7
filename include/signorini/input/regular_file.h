#ifndef signorini_input_regular_file_h
#define signorini_input_regular_file_h

#include <cstdint>
#include <string>

namespace Signorini
{
  /** Largest size of a text file that a person writes, in bytes. */
  constexpr std::uintmax_t largest_text = 10'000'000;

  /** Largest size of a file that a program writes, in bytes. */
  constexpr std::uintmax_t largest_data = 4'000'000'000;

  /**
   * Refuses what reading would hang on or fill the memory with: pipes, devices,
   * folders, and files without end. One that is not there is left to the
   * caller.
   * @param path    of the file
   * @param largest size allowed, in bytes
   * @throws InputError which begins with the quoted path
   */
  void
  require_regular_file(const std::string &path, const std::uintmax_t largest);
} // namespace Signorini

#endif
