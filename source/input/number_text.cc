#include <signorini/input/as_text.h>
#include <signorini/input/input_error.h>
#include <signorini/input/named_list.h>
#include <signorini/input/number_text.h>

#include <deal.II/base/utilities.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <functional>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    const std::string number_text  = "[Numbers]";
    const std::string behind_name  = "[Numbers behind names]";
    const std::string among_words  = "[Numbers among ";
    const std::string separators   = ",;:|";
    const std::string file_keyword = "file ";

    using Words = std::vector<std::string>;

    bool
    begins_with(const std::string &text, const std::string &begin)
    {
      return text.compare(0, begin.size(), begin) == 0;
    }

    bool
    is_in_name(const std::string &text, const std::size_t at)
    {
      return at < text.size() &&
             (std::isalnum(static_cast<unsigned char>(text[at])) ||
              text[at] == '_');
    }

    // Length of the word of the list that stands at this place, or 0.
    std::size_t
    word_length(const std::string &text,
                const std::size_t  at,
                const Words       &words)
    {
      if (at > 0 && is_in_name(text, at - 1))
        return 0;
      for (const std::string &word : words)
        if (text.compare(at, word.size(), word) == 0 &&
            !is_in_name(text, at + word.size()))
          return word.size();
      return 0;
    }

    bool
    is_literal(const std::string &text)
    {
      char *end = nullptr;
      std::strtod(text.c_str(), &end);
      return end == text.c_str() + text.size();
    }

    std::string
    evaluate(const std::string &expression,
             const bool         is_whole,
             const Constants   &constants)
    {
      const double value = Formula(expression, {}, constants, "").value({});
      if (!is_whole)
        return shortest_exact(value);
      const double whole = std::round(value);
      if (std::abs(value - whole) > 1e-9 * std::max(1., std::abs(value)) ||
          std::abs(whole) > 1e15)
        throw InputError("",
                         "the expression \"" + expression + "\" is " +
                           shortest_exact(value) +
                           ", but a whole number is expected.");
      return std::to_string(static_cast<long long>(whole));
    }

    // With the blanks around it.
    std::string
    evaluate_piece(const std::string &piece,
                   const bool         is_whole,
                   const Constants   &constants)
    {
      const std::string text = Utilities::trim(piece);
      if (is_literal(text))
        return piece;
      std::string result = piece;
      return result.replace(piece.find(text),
                            text.size(),
                            evaluate(text, is_whole, constants));
    }

    std::string
    evaluate_pieces(
      const std::string                                     &text,
      const Words                                           &words,
      const std::function<std::string(const std::string &)> &number)
    {
      std::string result, piece;
      int         depth = 0; // of parentheses
      for (std::size_t i = 0; i < text.size();)
        {
          const bool is_sign = separators.find(text[i]) != std::string::npos;
          const std::size_t length = depth > 0 ? 0 :
                                     is_sign   ? 1 :
                                                 word_length(text, i, words);
          if (length > 0)
            {
              result += number(piece) + text.substr(i, length);
              piece.clear();
              i += length;
              continue;
            }
          depth += text[i] == '(' ? 1 : text[i] == ')' ? -1 : 0;
          piece += text[i++];
        }
      return result + number(piece);
    }

    std::string
    evaluate_behind_names(
      const std::string                                     &text,
      const std::function<std::string(const std::string &)> &number)
    {
      std::string result;
      for (std::size_t begin = 0; begin < text.size();)
        {
          const std::size_t end  = std::min(text.find(';', begin), text.size());
          const std::size_t name = std::min(text.find(':', begin), end);
          result += text.substr(begin, name - begin) +
                    evaluate_pieces(text.substr(name, end - name), {}, number) +
                    text.substr(end, 1);
          begin = end + 1;
        }
      return result;
    }

    Words
    words_of(const std::string &pattern)
    {
      if (!begins_with(pattern, among_words))
        return {};
      return Utilities::split_string_list(
        pattern.substr(among_words.size(),
                       pattern.size() - among_words.size() - 1),
        ' ');
    }
  } // namespace



  NumberText::NumberText(const Words &words)
    : description_(number_text)
  {
    if (words.empty())
      return;
    description_ = among_words;
    for (const std::string &word : words)
      description_ += (word == words.front() ? "" : " ") + word;
    description_ += "]";
  }



  NumberText
  NumberText::behind_names()
  {
    NumberText pattern;
    pattern.description_ = behind_name;
    return pattern;
  }



  bool
  NumberText::match(const std::string &) const
  {
    return true;
  }



  std::string
  NumberText::description(const OutputStyle) const
  {
    return description_;
  }



  std::unique_ptr<Patterns::PatternBase>
  NumberText::clone() const
  {
    return std::make_unique<NumberText>(*this);
  }



  std::string
  evaluate_numbers(const std::string &value,
                   const std::string &pattern,
                   const Constants   &constants)
  {
    const bool is_whole = pattern.find("[Integer") != std::string::npos;
    const bool is_text  = begins_with(pattern, "[Numbers");
    if (!is_whole && !is_text && pattern.find("[Double") == std::string::npos)
      return value;
    if (is_text && begins_with(value, file_keyword))
      return value;
    const auto number = [&](const std::string &piece) {
      return evaluate_piece(piece, is_whole, constants);
    };
    return pattern == behind_name ?
             evaluate_behind_names(value, number) :
             evaluate_pieces(value, words_of(pattern), number);
  }
} // namespace Signorini
