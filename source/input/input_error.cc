#include <signorini/input/input_error.h>

namespace Signorini
{
  InputError::InputError(const std::string &text)
    : InputError("", text)
  {}



  InputError::InputError(const std::string &entry, const std::string &text)
    : InputError(entry, text, entry.empty() ? text : entry + ": " + text)
  {}



  InputError::InputError(const std::string &entry,
                         const std::string &text,
                         const std::string &message)
    : std::runtime_error(message)
    , entry_(entry)
    , text_(text)
  {}



  InputError
  InputError::of_value(const std::string &entry,
                       const std::string &value,
                       const std::string &text)
  {
    return InputError(entry, text, entry + " = " + value + ": " + text);
  }



  InputError
  InputError::in_section(const std::string &section) const
  {
    return InputError(entry_.empty() ? section : section + " / " + entry_,
                      text_,
                      section + " / " + what());
  }
} // namespace Signorini
