#include <signorini/geometry/files/word_reader.h>
#include <signorini/input/input_error.h>

#include <deal.II/base/utilities.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <limits>
#include <utility>

namespace Signorini
{
  namespace
  {
    bool
    is_space(const char c)
    {
      return std::isspace(static_cast<unsigned char>(c)) != 0;
    }

    // True if the whole word is a number of this type.
    template <typename Number>
    bool
    convert(const std::string &word, Number &value)
    {
      const char *const begin = word.data() + (word.rfind('+', 0) == 0 ? 1 : 0);
      const char *const end   = word.data() + word.size();
      const auto        result = std::from_chars(begin, end, value);
      return result.ec == std::errc() && result.ptr == end;
    }
  } // namespace



  WordReader::WordReader(std::string file_name, std::string text)
    : file_name(std::move(file_name))
    , text(std::move(text))
  {}



  void
  WordReader::skip_white_space()
  {
    for (; position < text.size() && is_space(text[position]); ++position)
      if (text[position] == '\n')
        ++line_number;
  }



  bool
  WordReader::has_word()
  {
    skip_white_space();
    return position < text.size();
  }



  std::string
  WordReader::word(const std::string &what)
  {
    if (!has_word())
      fail("the file ends where " + what +
           " should follow; it is not complete. Save or copy it again.");
    const std::size_t begin = position;
    while (position < text.size() && !is_space(text[position]))
      ++position;
    return text.substr(begin, position - begin);
  }



  double
  WordReader::number(const std::string &what)
  {
    return to_number(word(what), what);
  }



  long
  WordReader::integer(const std::string &what)
  {
    return to_integer(word(what), what);
  }



  double
  WordReader::to_number(const std::string &word, const std::string &what) const
  {
    double value = 0.;
    if (!convert(word, value) || !std::isfinite(value))
      fail("found \"" + word + "\" instead of " + what + ".");
    return value;
  }



  long
  WordReader::to_integer(const std::string &word, const std::string &what) const
  {
    long value = 0;
    if (!convert(word, value))
      fail("found \"" + word + "\" instead of " + what + ".");
    return value;
  }



  unsigned int
  WordReader::count(const std::string &what)
  {
    const long value = integer(what);
    if (value < 0 || value > std::numeric_limits<int>::max())
      fail("found \"" + std::to_string(value) + "\" instead of " + what + ".");
    return static_cast<unsigned int>(value);
  }



  std::string
  WordReader::quoted(const std::string &what)
  {
    skip_white_space();
    const std::size_t end_of_line = text.find('\n', position);
    const std::size_t end = position < text.size() && text[position] == '"' ?
                              text.find('"', position + 1) :
                              std::string::npos;
    if (end >= end_of_line)
      fail("found no " + what + " in quotation marks.");
    const std::string result = text.substr(position + 1, end - position - 1);
    position                 = end + 1;
    return result;
  }



  std::string
  WordReader::line()
  {
    const std::size_t end    = std::min(text.find('\n', position), text.size());
    const std::string result = text.substr(position, end - position);
    position                 = end;
    return dealii::Utilities::trim(result);
  }



  void
  WordReader::fail(const std::string &message) const
  {
    throw InputError(file_name + ", line " + std::to_string(line_number) +
                     ": " + message);
  }
} // namespace Signorini
