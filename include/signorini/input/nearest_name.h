#ifndef signorini_input_nearest_name_h
#define signorini_input_nearest_name_h

#include <string>
#include <vector>

namespace Signorini
{
  /**
   * The candidate that a misspelt @p name most likely stands for: the one with
   * the smallest edit distance (insertions, deletions and replacements of
   * single characters; upper and lower case count as equal). Empty if every
   * candidate differs in more than a third of the characters (two are always
   * allowed, but never all of them). The first of several equally near ones.
   */
  std::string
  nearest_name(const std::string              &name,
               const std::vector<std::string> &candidates);

  /** ` Did you mean "rim"?` for an error message, or nothing. */
  std::string
  did_you_mean(const std::string              &name,
               const std::vector<std::string> &candidates);

  /** `a, b, c`, or `none` for an empty list. */
  std::string
  comma_separated(const std::vector<std::string> &names);
} // namespace Signorini

#endif
