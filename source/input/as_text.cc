#include <signorini/input/as_text.h>

#include <cctype>
#include <charconv>
#include <sstream>

namespace Signorini
{
  std::string
  as_text(const double value)
  {
    std::ostringstream text;
    text << value;
    return text.str();
  }



  std::string
  shortest_exact(const double value)
  {
    char       text[32];
    const auto result = std::to_chars(text, text + sizeof(text), value);
    return std::string(text, result.ptr);
  }



  std::string
  as_sentence(std::string text)
  {
    if (!text.empty())
      text[0] =
        static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
    return text;
  }
} // namespace Signorini
