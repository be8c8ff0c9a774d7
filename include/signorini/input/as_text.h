#ifndef signorini_input_as_text_h
#define signorini_input_as_text_h

#include <string>

namespace Signorini
{
  /** @p value with six digits, as messages show numbers. */
  std::string
  as_text(const double value);
} // namespace Signorini

#endif
