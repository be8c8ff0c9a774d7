#include <signorini/input/input_error.h>

namespace Signorini
{
  InputError::InputError(const std::string &text)
    : InputError("", text)
  {}



  InputError::InputError(const std::string &entry, const std::string &text)
    : std::runtime_error(entry.empty() ? text : entry + ": " + text)
    , entry_(entry)
    , text_(text)
  {}
} // namespace Signorini
