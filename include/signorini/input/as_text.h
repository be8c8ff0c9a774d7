#ifndef signorini_input_as_text_h
#define signorini_input_as_text_h

#include <string>

namespace Signorini
{
  /** @p value with six digits, as messages show numbers. */
  std::string
  as_text(const double value);

  /** The shortest decimal text that reads back as exactly this number. */
  std::string
  shortest_exact(const double value);

  /** With a capital letter. */
  std::string
  as_sentence(std::string text);
} // namespace Signorini

#endif
