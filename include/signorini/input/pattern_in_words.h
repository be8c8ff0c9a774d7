#ifndef signorini_input_pattern_in_words_h
#define signorini_input_pattern_in_words_h

#include <string>
#include <vector>

namespace Signorini
{
  /**
   * What a dealii::Patterns pattern allows, for a message to the user: "a
   * number >= 0" instead of "[Double 0...MAX_DOUBLE (inclusive)]".
   *
   * @param description the machine description of the pattern. A kind of
   * pattern that is not known here is returned as it stands.
   */
  std::string
  pattern_in_words(const std::string &description);

  /**
   * The names a Patterns::Selection or MultipleSelection allows, alone or as
   * the element of a list; empty for every other pattern.
   */
  std::vector<std::string>
  names_in_pattern(const std::string &description);
} // namespace Signorini

#endif
