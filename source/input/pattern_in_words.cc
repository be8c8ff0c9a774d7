#include <signorini/input/nearest_name.h>
#include <signorini/input/pattern_in_words.h>

#include <deal.II/base/utilities.h>

#include <limits>
#include <regex>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /** " >= a", " <= b", " from a to b", or nothing for an open range. */
    std::string
    range_in_words(const std::string &from,
                   const std::string &to,
                   const std::string &smallest,
                   const std::string &largest)
    {
      if (from == smallest && to == largest)
        return "";
      if (to == largest)
        return " >= " + from;
      if (from == smallest)
        return " <= " + to;
      return " from " + from + " to " + to;
    }



    std::string
    number_in_words(const std::string &description)
    {
      static const std::regex real_range(
        R"(\[Double (\S+?)\.\.\.(\S+) \(inclusive\)\])");
      static const std::regex integer_range(
        R"(\[Integer range (\S+?)\.\.\.(\S+) \(inclusive\)\])");
      std::smatch found;
      if (std::regex_match(description, found, real_range))
        return "a number" +
               range_in_words(found[1], found[2], "-MAX_DOUBLE", "MAX_DOUBLE");
      if (std::regex_match(description, found, integer_range))
        return "a whole number" +
               range_in_words(found[1],
                              found[2],
                              std::to_string(std::numeric_limits<int>::min()),
                              std::to_string(std::numeric_limits<int>::max()));
      if (description == "[Integer]")
        return "a whole number";
      return "";
    }



    /** A list pattern taken apart; not a list when `element` is empty. */
    struct ListPattern
    {
      std::string element;
      std::string smallest_length;
      std::string largest_length;
      std::string separator;
    };



    ListPattern
    list_pattern(const std::string &description)
    {
      static const std::regex list(
        R"(\[List of <(.*)> of length (\d+)\.\.\.(\d+) \(inclusive\))"
        R"((?: separated by <(.)>)?\])");
      std::smatch found;
      if (!std::regex_match(description, found, list))
        return {};
      return {found[1],
              found[2],
              found[3],
              found[4].matched ? found[4].str() : ","};
    }



    std::string
    list_in_words(const ListPattern &list)
    {
      const std::string no_limit =
        std::to_string(std::numeric_limits<unsigned int>::max());
      std::string length;
      if (list.smallest_length == list.largest_length)
        length = list.smallest_length + " of them";
      else if (list.largest_length != no_limit)
        length =
          list.smallest_length + " to " + list.largest_length + " of them";
      else if (list.smallest_length != "0")
        length = "at least " + list.smallest_length;
      return "a list, separated by \"" + list.separator + "\"" +
             (length.empty() ? "" : ", " + length) +
             ", of: " + pattern_in_words(list.element);
    }
  } // namespace



  std::string
  pattern_in_words(const std::string &description)
  {
    const std::string number = number_in_words(description);
    if (!number.empty())
      return number;
    const ListPattern list = list_pattern(description);
    if (!list.element.empty())
      return list_in_words(list);
    const std::vector<std::string> names = names_in_pattern(description);
    if (!names.empty())
      return (description.rfind("[Multiple", 0) == 0 ?
                "a list, separated by \",\", of: " :
                "one of ") +
             comma_separated(names);
    if (description.rfind("[Numbers", 0) == 0)
      return "numbers";
    if (description == "[Bool]")
      return "true or false";
    if (description == "[Anything]")
      return "any text";
    if (description.rfind("[FileName", 0) == 0)
      return "the name of a file";
    if (description == "[DirectoryName]")
      return "the name of a folder";
    return description;
  }



  std::vector<std::string>
  names_in_pattern(const std::string &description)
  {
    const ListPattern list = list_pattern(description);
    if (!list.element.empty())
      return names_in_pattern(list.element);
    static const std::regex selection(R"(\[(?:Multiple)?Selection (.*?) ?\])");
    std::smatch             found;
    if (!std::regex_match(description, found, selection))
      return {};
    return Utilities::split_string_list(found[1].str(), '|');
  }

} // namespace Signorini
