#include <signorini/input/as_text.h>

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
} // namespace Signorini
