#ifndef signorini_input_shell_word_h
#define signorini_input_shell_word_h

#include <string>

namespace Signorini
{
  /** A text as one word of a command line, in quotes where a shell needs
   * them. */
  std::string
  quoted(const std::string &text);
} // namespace Signorini

#endif
