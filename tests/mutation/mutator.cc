#include "mutator.h"

#include <algorithm>
#include <cctype>
#include <sstream>

namespace
{
  using Strings = std::vector<std::string>;

  // No count that is legal and takes minutes.
  const Strings numbers = {"0",     "-1",     "1",          "2",        "3",
                           "-0.5",  "0.5",    "1e-3",       "1e3",      "-1e9",
                           "1e9",   "1e30",   "-1e300",     "1e300",    "1e400",
                           "1e-30", "1e-320", "4294967296", "20000000", "nan",
                           "inf",   "-inf",   "1e",         "0x10",     "1/0",
                           "",      "1,5",    "--1",        "1 2"};

  const Strings values = {"sqrt(-1)",
                          "1/(t - 0.5e-5)",
                          "log(t)",
                          "((((((",
                          "0 ; x",
                          "t^t ; y",
                          "a-b = 1",
                          "sin = 2",
                          "x, y, z",
                          "left: x, y, z, w",
                          "left: 0 ; 1/x | right: sqrt(t - 1)",
                          "no.such on thing",
                          "max(",
                          "max(time) = nan +- 0",
                          "first(time > ) < 1",
                          "\x01\xff\xfe",
                          "ä",
                          "|||",
                          ";;;",
                          ":",
                          ","};

  Strings
  lines_of(const std::string &text)
  {
    std::istringstream stream(text);
    Strings            lines;
    for (std::string line; std::getline(stream, line);)
      lines.push_back(line);
    return lines;
  }

  std::string
  joined(const Strings &lines)
  {
    std::string text;
    for (const std::string &line : lines)
      text += line + '\n';
    return text;
  }

  bool
  is_of_number(const char c)
  {
    return std::isdigit(static_cast<unsigned char>(c)) || c == '.';
  }

  // Begin and length of each run of characters of a kind.
  template <typename Kind>
  std::vector<std::pair<std::size_t, std::size_t>>
  runs(const std::string &text, const Kind &is_of_kind)
  {
    std::vector<std::pair<std::size_t, std::size_t>> list;
    for (std::size_t at = 0; at < text.size();)
      {
        std::size_t end = at;
        while (end < text.size() && is_of_kind(text[end]))
          ++end;
        if (end > at)
          list.emplace_back(at, end - at);
        at = end + 1;
      }
    return list;
  }
} // namespace



Mutator::Mutator(const unsigned int seed, const std::vector<std::string> &pool)
  : generator(seed)
{
  for (const std::string &text : pool)
    for (const std::string &line : lines_of(text))
      {
        pool_lines.push_back(line);
        std::istringstream words(line);
        for (std::string word; words >> word;)
          pool_words.push_back(word);
      }
}



std::size_t
Mutator::choose(const std::size_t n)
{
  // Not std::uniform_int_distribution, which libraries do in their own ways.
  return n == 0 ? 0 : generator() % n;
}



const std::string &
Mutator::any(const std::vector<std::string> &list)
{
  return list[choose(list.size())];
}



std::string
Mutator::mutate(std::string text)
{
  const std::size_t n_changes = 1 + choose(3);
  for (std::size_t i = 0; i < n_changes; ++i)
    switch (choose(8))
      {
        case 0:
        case 1:
        case 2:
          change_number(text);
          break;
        case 3:
          change_value(text);
          break;
        case 4:
          change_lines(text);
          break;
        case 5:
        case 6:
          change_word(text);
          break;
        default:
          change_bytes(text);
      }
  return text;
}



void
Mutator::change_number(std::string &text)
{
  const auto places = runs(text, is_of_number);
  if (places.empty())
    return;
  const auto [begin, length] = places[choose(places.size())];
  text.replace(begin, length, any(numbers));
}



// What stands behind an equals sign.
void
Mutator::change_value(std::string &text)
{
  Strings                  lines = lines_of(text);
  std::vector<std::size_t> assignments;
  for (std::size_t i = 0; i < lines.size(); ++i)
    if (lines[i].find('=') != std::string::npos)
      assignments.push_back(i);
  if (assignments.empty())
    return;
  std::string &line = lines[assignments[choose(assignments.size())]];
  line              = line.substr(0, line.find('=') + 1) + " " + any(values);
  text              = joined(lines);
}



void
Mutator::change_lines(std::string &text)
{
  Strings lines = lines_of(text);
  if (lines.empty())
    return;
  const std::size_t i = choose(lines.size());
  switch (choose(5))
    {
      case 0:
        lines.erase(lines.begin() + i);
        break;
      case 1:
        lines.insert(lines.begin() + i, std::string(lines[i]));
        break;
      case 2:
        std::swap(lines[i], lines[choose(lines.size())]);
        break;
      case 3:
        lines.resize(i);
        break;
      default:
        lines.insert(lines.begin() + i, any(pool_lines));
    }
  text = joined(lines);
}



void
Mutator::change_word(std::string &text)
{
  const auto places = runs(text, [](const char c) {
    return !std::isspace(static_cast<unsigned char>(c));
  });
  if (places.empty())
    return;
  const auto [begin, length] = places[choose(places.size())];
  text.replace(begin, length, choose(5) == 0 ? "" : any(pool_words));
}



void
Mutator::change_bytes(std::string &text)
{
  const std::string signs = "=;:,|()\\#.-+*/ \t\n\"'{}$&%0";
  for (std::size_t n = 1 + choose(4); n > 0 && !text.empty(); --n)
    {
      const std::size_t at = choose(text.size());
      switch (choose(5))
        {
          case 0:
            text[at] = static_cast<char>(generator());
            break;
          case 1:
            text.erase(at, 1);
            break;
          case 2:
            text.insert(at, 1, signs[choose(signs.size())]);
            break;
          case 3:
            text.erase(at); // cut short
            break;
          default:
            text[at] = signs[choose(signs.size())];
        }
    }
}
