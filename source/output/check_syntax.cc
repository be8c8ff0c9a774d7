#include <signorini/input/input_error.h>
#include <signorini/output/check_syntax.h>

#include <cctype>

namespace Signorini
{
  namespace CheckSyntax
  {
    namespace
    {
      bool
      is_digit(const char c)
      {
        return std::isdigit(static_cast<unsigned char>(c)) != 0;
      }

      bool
      is_letter(const char c)
      {
        return std::isalpha(static_cast<unsigned char>(c)) != 0 || c == '_';
      }

      std::size_t
      skip_digits(const std::string &text, std::size_t position)
      {
        while (position < text.size() && is_digit(text[position]))
          ++position;
        return position;
      }
    } // namespace



    std::string
    trim(const std::string &text)
    {
      const std::string blanks = " \t\r\n";
      const std::size_t begin  = text.find_first_not_of(blanks);
      if (begin == std::string::npos)
        return "";
      return text.substr(begin, text.find_last_not_of(blanks) - begin + 1);
    }



    std::size_t
    closing_parenthesis(const std::string &text, const std::size_t open)
    {
      int depth = 0;
      for (std::size_t i = open; i < text.size(); ++i)
        if (text[i] == '(')
          ++depth;
        else if (text[i] == ')' && --depth == 0)
          return i;
      throw InputError("A closing parenthesis is missing in '" + trim(text) +
                       "'.");
    }



    std::vector<std::size_t>
    find_outside(const std::string &text, const std::string &wanted)
    {
      std::vector<std::size_t> positions;
      for (std::size_t i = 0; i < text.size(); ++i)
        if (text[i] == '(')
          i = closing_parenthesis(text, i);
        else if (text[i] == ')')
          throw InputError("There is one closing parenthesis too many in '" +
                           trim(text) + "'.");
        else if (wanted.find(text[i]) != std::string::npos)
          positions.push_back(i);
      return positions;
    }



    std::vector<std::string>
    split_outside(const std::string &text, const char separator)
    {
      std::vector<std::string> parts;
      std::size_t              begin = 0;
      for (const std::size_t position :
           find_outside(text, std::string(1, separator)))
        {
          parts.push_back(trim(text.substr(begin, position - begin)));
          begin = position + 1;
        }
      parts.push_back(trim(text.substr(begin)));
      return parts;
    }



    std::size_t
    number_length(const std::string &text, const std::size_t begin)
    {
      std::size_t end = skip_digits(text, begin);
      if (end < text.size() && text[end] == '.')
        end = skip_digits(text, end + 1);
      if (end == begin || (end == begin + 1 && text[begin] == '.'))
        return 0;
      if (end < text.size() && (text[end] == 'e' || text[end] == 'E'))
        {
          std::size_t digits = end + 1;
          if (digits < text.size() &&
              (text[digits] == '+' || text[digits] == '-'))
            ++digits;
          if (skip_digits(text, digits) > digits)
            end = skip_digits(text, digits);
        }
      return end - begin;
    }



    std::size_t
    name_length(const std::string &text, const std::size_t begin)
    {
      if (begin >= text.size() || !is_letter(text[begin]))
        return 0;
      std::size_t end = begin;
      while (end < text.size() &&
             (is_letter(text[end]) || is_digit(text[end]) || text[end] == '.'))
        ++end;
      return end - begin;
    }
  } // namespace CheckSyntax
} // namespace Signorini
