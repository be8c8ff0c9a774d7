#include <signorini/input/formula.h>
#include <signorini/input/input_error.h>
#include <signorini/input/named_list.h>
#include <signorini/input/nearest_name.h>
#include <signorini/input/silenced_errors.h>

#include <deal.II/base/point.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstring>
#include <sstream>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    // Longer ones are no work of a pen, and nested parentheses of any number
    // would fill the stack.
    constexpr std::size_t longest_expression = 10000;

    // Those of muParser and deal.II, but for random numbers: a formula has to
    // say the same each time it is asked.
    const std::vector<std::string> &
    functions()
    {
      static const std::vector<std::string> list = {
        "abs",  "acos",  "acosh", "asin", "asinh", "atan", "atan2", "atanh",
        "avg",  "ceil",  "cos",   "cosh", "cot",   "csc",  "erf",   "erfc",
        "exp",  "floor", "if",    "int",  "ln",    "log",  "log10", "log2",
        "max",  "min",   "pow",   "rint", "sec",   "sign", "sin",   "sinh",
        "sqrt", "sum",   "tan",   "tanh"};
      return list;
    }

    bool
    begins_name(const char c)
    {
      return std::isalpha(static_cast<unsigned char>(c)) || c == '_';
    }

    bool
    belongs_to_name(const char c)
    {
      return std::isalnum(static_cast<unsigned char>(c)) || c == '_';
    }

    bool
    is_name(const std::string &text)
    {
      return !text.empty() && begins_name(text[0]) &&
             std::all_of(text.begin(), text.end(), belongs_to_name);
    }

    bool
    contains(const std::vector<std::string> &names, const std::string &name)
    {
      return std::find(names.begin(), names.end(), name) != names.end();
    }

    // The end of the number that begins at @p at: "1.5e-3", not "e" alone.
    std::size_t
    number_end(const std::string &text, std::size_t at)
    {
      const auto digits = [&](std::size_t i) {
        while (
          i < text.size() &&
          (std::isdigit(static_cast<unsigned char>(text[i])) || text[i] == '.'))
          ++i;
        return i;
      };
      at = digits(at);
      if (at < text.size() && (text[at] == 'e' || text[at] == 'E'))
        {
          std::size_t exponent = at + 1;
          if (exponent < text.size() &&
              (text[exponent] == '+' || text[exponent] == '-'))
            ++exponent;
          if (digits(exponent) > exponent)
            at = digits(exponent);
        }
      return at;
    }

    std::vector<std::string>
    names_in(const std::string &text)
    {
      std::vector<std::string> names;
      for (std::size_t at = 0; at < text.size();)
        if (begins_name(text[at]))
          {
            std::size_t end = at;
            while (end < text.size() && belongs_to_name(text[end]))
              ++end;
            names.push_back(text.substr(at, end - at));
            at = end;
          }
        else
          at = std::max(at + 1, number_end(text, at));
      return names;
    }

    std::vector<std::string>
    names_of(const Constants &constants)
    {
      std::vector<std::string> names;
      for (const auto &[name, number] : constants)
        names.push_back(name);
      return names;
    }

    std::string
    allowed_names(const std::vector<std::string> &variables,
                  const Constants                &constants)
    {
      const std::string allowed_constants =
        "the constants " + comma_separated(names_of(constants)) +
        " (more of them: entry Constants), and ";
      if (variables.empty())
        return " Allowed are numbers, " + allowed_constants +
               "functions such as sqrt, sin and max.";
      return " Allowed are the variables " + comma_separated(variables) + ", " +
             allowed_constants + "the functions " +
             comma_separated(functions()) + ".";
    }

    // What muParser takes and no formula of the .prm can mean: an assignment,
    // and several expressions of which the last counts, as in 1,5.
    std::string
    misunderstanding(const std::string &text)
    {
      int depth = 0;
      for (std::size_t i = 0; i < text.size(); ++i)
        {
          depth += text[i] == '(' ? 1 : text[i] == ')' ? -1 : 0;
          if (text[i] == ',' && depth <= 0)
            return " has a comma that parts no arguments of a function. "
                   "Decimals stand behind a point.";
          const bool compares = (i > 0 && std::strchr("=<>!", text[i - 1])) ||
                                (i + 1 < text.size() && text[i + 1] == '=');
          if (text[i] == '=' && !compares)
            return " has a single =, which sets nothing here. Equality is "
                   "written ==.";
        }
      return "";
    }

    // What deal.II says about the place, in one line.
    std::string
    in_one_line(const ExceptionBase &error)
    {
      std::ostringstream text;
      error.print_info(text);
      std::istringstream words(text.str());
      std::string        line, word;
      while (words >> word)
        line += " " + word;
      return line;
    }
  } // namespace



  const std::vector<std::string> Formula::space_and_time = {"x", "y", "z", "t"};



  Constants
  parse_constants(const std::string &text, const std::string &entry)
  {
    Constants constants = only_pi();
    for (const std::string &item : split_list(text, ','))
      {
        const std::size_t equal  = item.find('=');
        const std::string name   = Utilities::trim(item.substr(0, equal));
        const std::string prefix = "found \"" + item + "\"";
        if (equal == std::string::npos || !is_name(name))
          throw InputError(
            entry,
            prefix + ". Write \"name = number\" with commas between. A "
                     "name has letters, digits and _, and begins with no "
                     "digit.");
        if (contains(Formula::space_and_time, name) || name == "v")
          throw InputError(entry,
                           prefix +
                             ", but x, y, z, t and v are the variables of "
                             "expressions. Choose another name.");
        if (contains(functions(), name) || name == "_e" || name == "_pi")
          throw InputError(entry,
                           prefix + ", but " + name +
                             " is the name of a function. Choose another one.");
        if (constants.count(name) > 0)
          throw InputError(entry,
                           prefix + ", but " + name +
                             " has a value already. Choose another name.");
        constants[name] =
          parse_number(item.substr(equal + 1), entry, constants);
      }
    return constants;
  }



  Formula::Formula(const std::string              &text,
                   const std::vector<std::string> &variables,
                   const Constants                &constants,
                   const std::string              &entry)
    : text_(Utilities::trim(text))
    , variables_(variables)
    , entry_(entry)
    , names_(names_in(text))
    , parser_(std::make_shared<FunctionParser<3>>(1))
  {
    AssertIndexRange(variables.size(), 5);
    if (text_.size() > longest_expression)
      throw InputError(entry,
                       "the expression has " + std::to_string(text_.size()) +
                         " characters, allowed are " +
                         std::to_string(longest_expression) + ".");
    check_names(constants);
    const std::string mistake = misunderstanding(text_);
    if (!mistake.empty())
      throw InputError(entry, "the expression \"" + text_ + "\"" + mistake);

    // The parser wants three coordinates and the time.
    std::string names = comma_separated(variables_);
    if (variables_.empty())
      names.clear();
    for (std::size_t i = variables_.size(); i < 4; ++i)
      names += (names.empty() ? "" : ",") + ("unused_" + std::to_string(i));
    names.erase(std::remove(names.begin(), names.end(), ' '), names.end());
    std::string          reason;
    const SilencedErrors silence;
    try
      {
        parser_->initialize(names, text_, constants, true);
        parser_->value(Point<3>());
        return;
      }
    catch (const ExceptionBase &error)
      {
        reason = in_one_line(error);
      }
    catch (...) // muParser's own error is no std::exception
      {}
    throw InputError(entry,
                     "cannot read the expression \"" + text_ + "\"." +
                       allowed_names(variables_, constants) + reason);
  }



  void
  Formula::check_names(const Constants &constants) const
  {
    const std::string begin = "the expression \"" + text_ + "\" ";
    for (const std::string &name : names_)
      {
        if (contains(variables_, name) || contains(functions(), name) ||
            constants.count(name) > 0 || name == "_e" || name == "_pi")
          continue;
        if (contains(space_and_time, name) || name == "v")
          throw InputError(entry_,
                           begin + "depends on " + name + ", but it may " +
                             (variables_.empty() ?
                                "depend on no variable" :
                                "depend on " + comma_separated(variables_) +
                                  " only") +
                             ".");
        std::vector<std::string> known = names_of(constants);
        known.insert(known.end(), variables_.begin(), variables_.end());
        known.insert(known.end(), functions().begin(), functions().end());
        throw InputError(entry_,
                         begin + "has the unknown name \"" + name + "\"." +
                           did_you_mean(name, known) +
                           allowed_names(variables_, constants));
      }
  }



  double
  Formula::value(const std::vector<double> &values) const
  {
    AssertDimension(values.size(), variables_.size());
    Point<3> point;
    for (unsigned int d = 0; d < std::min<std::size_t>(3, values.size()); ++d)
      point[d] = values[d];
    parser_->set_time(values.size() == 4 ? values[3] : 0.);
    const double result = parser_->value(point);
    if (!std::isfinite(result))
      throw_no_number(values, result);
    return result;
  }



  void
  Formula::throw_no_number(const std::vector<double> &values,
                           const double               result) const
  {
    std::ostringstream message;
    message << "the expression \"" << text_ << "\" is "
            << (std::isnan(result) ? "not a number" : "infinite");
    for (std::size_t i = 0; i < values.size(); ++i)
      message << (i == 0 ? " at " : ", ") << variables_[i] << " = "
              << values[i];
    message << ". It needs a finite value wherever it is used.";
    throw InputError(entry_, message.str());
  }



  bool
  Formula::depends_on(const std::string &variable) const
  {
    return contains(names_, variable);
  }
} // namespace Signorini
