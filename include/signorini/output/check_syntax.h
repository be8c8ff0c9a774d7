#ifndef signorini_output_check_syntax_h
#define signorini_output_check_syntax_h

#include <string>
#include <vector>

namespace Signorini
{
  /**
   * Small tools for reading formulas. "Outside" means outside of all
   * parentheses.
   */
  namespace CheckSyntax
  {
    /** Without spaces at both ends. */
    std::string
    trim(const std::string &text);

    /**
     * Position of the parenthesis that closes the one at @p open.
     * @throws InputError when there is none.
     */
    std::size_t
    closing_parenthesis(const std::string &text, const std::size_t open);

    /**
     * Positions of the characters of @p wanted outside.
     * @throws InputError when the parentheses do not match.
     */
    std::vector<std::size_t>
    find_outside(const std::string &text, const std::string &wanted);

    /** The trimmed parts between the separators outside. Throws as above. */
    std::vector<std::string>
    split_outside(const std::string &text, const char separator);

    /** Length of the number that begins at @p begin; 0 if none does. */
    std::size_t
    number_length(const std::string &text, const std::size_t begin);

    /** Length of the name (letters, digits, _ and .) there; 0 if none. */
    std::size_t
    name_length(const std::string &text, const std::size_t begin);
  } // namespace CheckSyntax
} // namespace Signorini

#endif
