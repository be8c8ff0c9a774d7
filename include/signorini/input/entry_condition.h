#ifndef signorini_input_entry_condition_h
#define signorini_input_entry_condition_h

#include <functional>
#include <string>
#include <vector>

namespace Signorini
{
  /**
   * Entries that are read only if another one, the choice, says so. A class
   * that declares its section tells these conditions beside it, so that an
   * entry without effect can be named.
   */
  struct EntryCondition
  {
    /** Names of entries or subsections of one section. */
    std::vector<std::string> names;

    /**
     * The entry that decides: one of the same section, or else of the nearest
     * section around it; `Time/Analysis' is that of the section Time.
     */
    std::string choice;

    /** The value of the choice, and whether it is no more than the default. */
    struct Choice
    {
      std::string value;
      bool        is_default;
    };

    /** Whether the names are read with this choice. */
    std::function<bool(const Choice &)> is_read;

    /** What to do about the choice, as in `Set Law = elasto-plastic'. */
    std::string remedy;

    /**
     * Who sets such an entry takes the choice for another one: a mistake, and
     * not only something left over.
     */
    bool contradicts;
  };

  using EntryConditions = std::vector<EntryCondition>;

  /** Read if the choice is one of these values. */
  EntryCondition
  read_with(const std::vector<std::string> &names,
            const std::string              &choice,
            const std::vector<std::string> &values);

  /** Read if the choice is set, to something else than its default. */
  EntryCondition
  read_if_set(const std::vector<std::string> &names, const std::string &choice);

  /** Read if the comma-separated list of the choice has this item. */
  EntryCondition
  read_if_listed(const std::vector<std::string> &names,
                 const std::string              &choice,
                 const std::string              &item);

  /** Read unless the list of the choice has all of these items. */
  EntryCondition
  read_unless_listed(const std::vector<std::string> &names,
                     const std::string              &choice,
                     const std::vector<std::string> &items);

  /** The subsection that describes a choice: `Half ball' that of half ball. */
  std::string
  section_name(std::string choice);

  /** The same condition for a mistake. */
  EntryCondition
  contradiction(EntryCondition condition);
} // namespace Signorini

#endif
