#ifndef signorini_contact_pair_entries_h
#define signorini_contact_pair_entries_h

#include <signorini/input/number_text.h>

#include <functional>
#include <string>

namespace dealii
{
  class ParameterHandler;
}

namespace Signorini
{
  /**
   * The entries of a pair: its own where they are set, else those of all pairs.
   */
  struct PairEntries
  {
    std::function<std::string(const std::string &)> get;  // the text
    std::function<std::string(const std::string &)> path; // for messages
  };

  /**
   * Declares an entry, of numbers unless told otherwise, in the section that @p
   * prm is in.
   * @param in_pair of one pair: where it is empty, that of all pairs counts
   */
  void
  declare_pair_entry(
    const std::string                   &name,
    const std::string                   &default_value,
    const std::string                   &documentation,
    const bool                           in_pair,
    dealii::ParameterHandler            &prm,
    const dealii::Patterns::PatternBase &pattern = NumberText());

  /** A number that is not negative. @throws InputError. */
  double
  parse_not_negative(const PairEntries &entries, const std::string &name);

  /** A number greater than zero. @throws InputError. */
  double
  parse_positive(const PairEntries &entries, const std::string &name);
} // namespace Signorini

#endif
