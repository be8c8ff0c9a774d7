#ifndef signorini_input_unread_entries_h
#define signorini_input_unread_entries_h

#include <signorini/input/entry_condition.h>
#include <signorini/input/parameter_file.h>

#include <deal.II/base/parameter_handler.h>

#include <string>
#include <utility>
#include <vector>

namespace Signorini
{
  /** Conditions, each with the section it is for: {"Body beam", "Material"}. */
  class ConditionList
  {
  public:
    struct Item
    {
      std::vector<std::string> section;
      EntryCondition           condition;
    };

    void
    add(const std::vector<std::string> &section,
        const EntryConditions          &conditions);

    std::vector<Item> items;
  };

  /**
   * Entries that are set and that nothing reads. What equals its default says
   * nothing, and is passed over.
   *
   * An entry that contradicts the choice is an error, if both stand in the
   * same file, or the choice in none. Where a file includes another one, or
   * the command line sets the choice, the entry is left over from another
   * variant, and is worth a warning only.
   *
   * @param prm      with the values of the file
   * @param defaults the same as it was declared
   * @return the warnings
   * @throws InputError with all errors, each with its place and the remedy
   */
  std::vector<std::string>
  warnings_of_unread_entries(const ParameterFile            &file,
                             const ConditionList            &conditions,
                             const dealii::ParameterHandler &prm,
                             const dealii::ParameterHandler &defaults);
} // namespace Signorini

#endif
