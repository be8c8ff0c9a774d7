#include <signorini/input/shell_word.h>

namespace Signorini
{
  std::string
  quoted(const std::string &text)
  {
    const std::string plain = "ABCDEFGHIJKLMNOPQRSTUVWXYZ"
                              "abcdefghijklmnopqrstuvwxyz0123456789%+,-./:@_";
    if (!text.empty() && text.find_first_not_of(plain) == std::string::npos)
      return text;
    // Within single quotes all but the quote itself is plain.
    std::string result = "'";
    for (const char c : text)
      result += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return result + "'";
  }
} // namespace Signorini
