#ifndef signorini_input_name_table_h
#define signorini_input_name_table_h

#include <deal.II/base/exceptions.h>

#include <initializer_list>
#include <string>
#include <utility>
#include <vector>

namespace Signorini
{
  /**
   * What the alternatives of an entry are called in the .prm. The same table
   * declares the entry and reads it, so that strings end here.
   */
  template <typename Choice>
  class NameTable
  {
  public:
    NameTable(
      const std::initializer_list<std::pair<std::string, Choice>> &entries)
      : entries_(entries)
    {}

    /** All names, as `dealii::Patterns::Selection` wants them: `a|b|c'. */
    std::string
    names() const
    {
      std::string list;
      for (const auto &[name, choice] : entries_)
        list += (list.empty() ? "" : "|") + name;
      return list;
    }

    /** What a name stands for; the pattern of the entry let no other pass. */
    Choice
    at(const std::string &text) const
    {
      for (const auto &[name, choice] : entries_)
        if (name == text)
          return choice;
      AssertThrow(false, dealii::ExcInternalError());
      return entries_.front().second;
    }

  private:
    std::vector<std::pair<std::string, Choice>> entries_;
  };
} // namespace Signorini

#endif
