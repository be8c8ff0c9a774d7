#include <signorini/input/input_error.h>
#include <signorini/output/check_syntax.h>
#include <signorini/output/expected_results.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <set>

namespace Signorini
{
  namespace
  {
    using namespace CheckSyntax;

    constexpr double nan = std::numeric_limits<double>::quiet_NaN();

    // Errors say which of the checks they are about.
    template <class Action>
    auto
    in_check(const std::string &text, const Action &action)
    {
      try
        {
          return action();
        }
      catch (const InputError &error)
        {
          throw InputError("In the expected result '" + text +
                           "': " + error.what());
        }
    }

    std::string
    short_number(const double value)
    {
      char text[32];
      std::snprintf(text, sizeof(text), "%.6g", value);
      return text;
    }

    // "name: condition [source]"; name and source may be missing.
    struct Parts
    {
      std::string name;
      std::string condition;
    };

    Parts
    take_apart(const std::string &text)
    {
      Parts             parts = {"", text};
      const std::size_t colon = text.find(':');
      // The colon behind a condition belongs to muParser: a > 1 ? b : c
      if (colon < text.find_first_of("()<>=?"))
        {
          parts = {trim(text.substr(0, colon)), trim(text.substr(colon + 1))};
          if (parts.name.empty())
            throw InputError("There is no name in front of the colon.");
        }
      const std::size_t bracket = parts.condition.rfind('[');
      if (bracket != std::string::npos && parts.condition.back() == ']')
        parts.condition = trim(parts.condition.substr(0, bracket));
      return parts;
    }

    struct Sides
    {
      std::string left;
      std::string relation;
      std::string right;

      // Empty for inequalities.
      std::string tolerance;
    };

    Sides
    split_sides(const std::string &text)
    {
      const std::vector<std::size_t> signs = find_outside(text, "=<>");
      // "<=" and ">=" are two characters, but one sign.
      const bool two_characters =
        signs.size() == 2 && signs[1] == signs[0] + 1 &&
        text[signs[1]] == '=' && text[signs[0]] != '=';
      if (signs.size() != 1 && !two_characters)
        throw InputError("There has to be exactly one of = < > <= >= in it, "
                         "as in max(column) = 1.5 +- 2 %.");

      const std::size_t n_characters = two_characters ? 2 : 1;
      Sides             sides;
      sides.left     = trim(text.substr(0, signs[0]));
      sides.relation = text.substr(signs[0], n_characters);
      sides.right    = trim(text.substr(signs[0] + n_characters));

      // The last one, as 3 +-2 could also be a formula.
      const std::size_t plus_minus = sides.right.rfind("+-");
      const bool        found      = plus_minus != std::string::npos;
      if (found != (sides.relation == "="))
        throw InputError(found ?
                           "Only an equation (=) has a tolerance (+-)." :
                           "An equation needs a tolerance, absolute or in %: "
                           "max(column) = 1.5 +- 0.01, or +- 2 %.");
      if (found)
        {
          sides.tolerance = trim(sides.right.substr(plus_minus + 2));
          sides.right     = trim(sides.right.substr(0, plus_minus));
        }
      return sides;
    }

    double
    constant(const CheckExpression &expression)
    {
      return expression.evaluate(History(), NoFields());
    }

    double
    parse_tolerance(const std::string &text,
                    const bool         relative,
                    const Constants   &constants)
    {
      const CheckExpression expression(
        relative ? text.substr(0, text.size() - 1) : text, constants);
      const double value =
        expression.is_constant() ? constant(expression) : nan;
      if (!(value >= 0.) || !std::isfinite(value))
        throw InputError("The tolerance was found as '" + text +
                         "'. It has to be a number that is not negative.");
      return relative ? value / 100. : value;
    }
  } // namespace



  ExpectedResults::ExpectedResults(const std::string &text,
                                   const Constants   &constants)
  {
    if (trim(text).empty())
      return;
    const auto parts =
      in_check(trim(text), [&]() { return split_outside(text, '|'); });
    std::set<std::string> names;
    for (const std::string &part : parts)
      // A separator at the end is no mistake.
      if (!part.empty())
        checks.push_back(in_check(part, [&]() {
          const Parts apart = take_apart(part);
          if (!apart.name.empty() && !names.insert(apart.name).second)
            throw InputError("There is another one of this name.");
          return parse(part, apart.condition, constants);
        }));
  }



  ExpectedResults::Check
  ExpectedResults::parse(const std::string &text,
                         const std::string &condition,
                         const Constants   &constants)
  {
    const Sides sides = split_sides(condition);
    const bool  relative =
      !sides.tolerance.empty() && sides.tolerance.back() == '%';
    const Relation relation =
      sides.relation == "="  ? Relation::equal :
      sides.relation == "<"  ? Relation::less :
      sides.relation == "<=" ? Relation::less_or_equal :
      sides.relation == ">"  ? Relation::greater :
                               Relation::greater_or_equal;

    Check check{text,
                CheckExpression(sides.left, constants),
                relation,
                CheckExpression(sides.right, constants),
                nan,
                relative};
    if (relation == Relation::equal)
      check.tolerance = parse_tolerance(sides.tolerance, relative, constants);
    if (relative && check.right.is_constant() && constant(check.right) == 0.)
      throw InputError("A tolerance in % of 0 allows nothing. "
                       "Give an absolute one.");
    return check;
  }



  void
  ExpectedResults::check_names(const History     &history,
                               const FieldLookup &fields) const
  {
    for (const Check &check : checks)
      in_check(check.text, [&]() {
        check.left.check_names(history, fields);
        check.right.check_names(history, fields);
      });
  }



  std::vector<CheckResult>
  ExpectedResults::evaluate(const History     &history,
                            const FieldLookup &fields) const
  {
    std::vector<CheckResult> results;
    for (const Check &check : checks)
      results.push_back(in_check(check.text, [&]() {
        return evaluate(check, history, fields);
      }));
    return results;
  }



  CheckResult
  ExpectedResults::evaluate(const Check       &check,
                            const History     &history,
                            const FieldLookup &fields)
  {
    CheckResult result{check.text, false, nan, nan, nan, ""};
    try
      {
        result.found    = check.left.evaluate(history, fields);
        result.expected = check.right.evaluate(history, fields);
      }
    catch (const NoValue &no_value)
      {
        result.reason = no_value.what();
        return result;
      }
    if (!std::isfinite(result.found) || !std::isfinite(result.expected))
      {
        result.reason = "not a finite number";
        return result;
      }

    switch (check.relation)
      {
        case Relation::equal:
          result.tolerance =
            check.tolerance * (check.relative ? std::abs(result.expected) : 1.);
          result.passed =
            std::abs(result.found - result.expected) <= result.tolerance;
          break;
        case Relation::less:
          result.passed = result.found < result.expected;
          break;
        case Relation::less_or_equal:
          result.passed = result.found <= result.expected;
          break;
        case Relation::greater:
          result.passed = result.found > result.expected;
          break;
        case Relation::greater_or_equal:
          result.passed = result.found >= result.expected;
          break;
      }
    return result;
  }



  unsigned int
  ExpectedResults::n_checks() const
  {
    return checks.size();
  }



  bool
  all_passed(const std::vector<CheckResult> &results)
  {
    return std::all_of(results.begin(),
                       results.end(),
                       [](const CheckResult &result) { return result.passed; });
  }



  std::string
  report(const std::vector<CheckResult> &results)
  {
    std::string text;
    for (const CheckResult &result : results)
      {
        text += (result.passed ? "passed  " : "missed  ") + result.text;
        if (result.reason.empty() || !std::isnan(result.found))
          text += "   found " + short_number(result.found) + ", expected " +
                  short_number(result.expected);
        if (!result.reason.empty())
          text += "   " + result.reason;
        else if (!std::isnan(result.tolerance))
          text += ", distance " +
                  short_number(std::abs(result.found - result.expected)) +
                  ", tolerance " + short_number(result.tolerance);
        text += "\n";
      }
    return text;
  }
} // namespace Signorini
