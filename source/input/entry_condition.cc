#include <signorini/input/entry_condition.h>
#include <signorini/input/named_list.h>

#include <algorithm>
#include <cctype>

namespace Signorini
{
  namespace
  {
    // "a", "a or b", "a, b or c"
    std::string
    alternatives(const std::vector<std::string> &values)
    {
      std::string text;
      for (std::size_t i = 0; i < values.size(); ++i)
        text += (i == 0                 ? "" :
                 i + 1 == values.size() ? " or " :
                                          ", ") +
                values[i];
      return text;
    }

    // The entry without the section it is found in.
    std::string
    last_name(const std::string &choice)
    {
      return choice.substr(choice.rfind('/') + 1);
    }

    bool
    is_listed(const std::string &list, const std::string &item)
    {
      const auto items = split_list(list, ',');
      return std::find(items.begin(), items.end(), item) != items.end();
    }
  } // namespace



  EntryCondition
  read_with(const std::vector<std::string> &names,
            const std::string              &choice,
            const std::vector<std::string> &values)
  {
    return {names,
            choice,
            [values](const EntryCondition::Choice &found) {
              return std::find(values.begin(), values.end(), found.value) !=
                     values.end();
            },
            "Set " + last_name(choice) + " = " + alternatives(values),
            false};
  }



  EntryCondition
  read_if_set(const std::vector<std::string> &names, const std::string &choice)
  {
    return {names,
            choice,
            [](const EntryCondition::Choice &found) {
              return !found.is_default;
            },
            "Set " + last_name(choice),
            false};
  }



  EntryCondition
  read_if_listed(const std::vector<std::string> &names,
                 const std::string              &choice,
                 const std::string              &item)
  {
    return {names,
            choice,
            [item](const EntryCondition::Choice &found) {
              return is_listed(found.value, item);
            },
            "Add " + item + " to " + last_name(choice),
            false};
  }



  EntryCondition
  read_unless_listed(const std::vector<std::string> &names,
                     const std::string              &choice,
                     const std::vector<std::string> &items)
  {
    return {names,
            choice,
            [items](const EntryCondition::Choice &found) {
              return std::any_of(items.begin(),
                                 items.end(),
                                 [&](const std::string &item) {
                                   return !is_listed(found.value, item);
                                 });
            },
            "Take " + alternatives(items) + " from " + last_name(choice),
            false};
  }



  std::string
  section_name(std::string choice)
  {
    choice[0] = std::toupper(static_cast<unsigned char>(choice[0]));
    return choice;
  }



  EntryCondition
  contradiction(EntryCondition condition)
  {
    condition.contradicts = true;
    return condition;
  }
} // namespace Signorini
