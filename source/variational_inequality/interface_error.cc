#include <signorini/variational_inequality/interface_error.h>

#include <algorithm>

namespace Signorini
{
  namespace
  {
    std::string
    list(const std::vector<unsigned int> &contacts)
    {
      constexpr std::size_t most = 10;
      if (contacts.empty())
        return ".";
      std::string text = ". Contacts:";
      for (std::size_t i = 0; i < std::min(contacts.size(), most); ++i)
        text += (i > 0 ? ", " : " ") + std::to_string(contacts[i]);
      if (contacts.size() > most)
        text += " and " + std::to_string(contacts.size() - most) + " more";
      return text + ".";
    }
  } // namespace



  InterfaceError::InterfaceError(const std::string               &message,
                                 const std::vector<unsigned int> &contacts)
    : ComputationError(message + list(contacts))
    , contact_numbers(contacts)
  {}
} // namespace Signorini
