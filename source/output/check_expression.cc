#include <signorini/input/as_text.h>
#include <signorini/input/input_error.h>
#include <signorini/input/nearest_name.h>
#include <signorini/input/silenced_errors.h>
#include <signorini/output/check_expression.h>
#include <signorini/output/check_syntax.h>

#include <deal.II/base/function_parser.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <sstream>

namespace Signorini
{
  namespace
  {
    using namespace CheckSyntax;

    enum class Subject
    {
      column,
      condition,
      field
    };

    struct Function
    {
      Subject subject;

      // Numbers of arguments allowed after the column, condition or field.
      std::vector<unsigned int> n_arguments;
      std::string               usage;
    };

    const std::map<std::string, Function> &
    functions()
    {
      static const std::map<std::string, Function> list = {
        {"max",
         {Subject::column, {0, 2}, "max(column) or max(column, t0, t1)"}},
        {"min",
         {Subject::column, {0, 2}, "min(column) or min(column, t0, t1)"}},
        {"max_abs",
         {Subject::column,
          {0, 2},
          "max_abs(column) or max_abs(column, t0, t1)"}},
        {"mean",
         {Subject::column, {0, 2}, "mean(column) or mean(column, t0, t1)"}},
        {"final",
         {Subject::column, {0, 2}, "final(column) or final(column, t0, t1)"}},
        {"at", {Subject::column, {1}, "at(column, t)"}},
        {"first", {Subject::condition, {0}, "first(column > value)"}},
        {"last", {Subject::condition, {0}, "last(column > value)"}},
        {"switches", {Subject::condition, {0}, "switches(column > value)"}},
        {"time", {Subject::condition, {1}, "time(column > value, switch k)"}},
        {"field_max", {Subject::field, {0}, "field_max(field)"}},
        {"field_min", {Subject::field, {0}, "field_min(field)"}},
        {"x_of_max", {Subject::field, {0}, "x_of_max(field)"}},
        {"y_of_max", {Subject::field, {0}, "y_of_max(field)"}},
        {"z_of_max", {Subject::field, {0}, "z_of_max(field)"}},
        {"x_of_min", {Subject::field, {0}, "x_of_min(field)"}},
        {"y_of_min", {Subject::field, {0}, "y_of_min(field)"}},
        {"z_of_min", {Subject::field, {0}, "z_of_min(field)"}},
        {"field",
         {Subject::field,
          {2, 3},
          "field(field, x, y) or field(field, x, y, z)"}}};
      return list;
    }

    std::string
    owner(const std::string &field)
    {
      return field.substr(0, field.rfind('.'));
    }

    // Of the many fields those of the body, boundary or pair that was meant;
    // if that is not known, those of bodies as a whole.
    std::vector<std::string>
    relatives(const std::string &wrong, const std::vector<std::string> &fields)
    {
      const std::string        meant = owner(nearest_name(wrong, fields));
      std::vector<std::string> result;
      for (const std::string &field : fields)
        if (meant.empty() ? std::count(field.begin(), field.end(), '.') < 2 :
                            owner(field) == meant)
          result.push_back(field);
      return result;
    }

    double
    constant(const std::string &name, const Constants &constants)
    {
      const auto found = constants.find(name);
      if (found != constants.end())
        return found->second;
      std::vector<std::string> names;
      for (const auto &[known, value] : constants)
        names.push_back(known);
      throw InputError("'" + name +
                       "' is not a number. A column has to stand in a "
                       "function, such as max(" +
                       name + ") or final(" + name + "). The constants are " +
                       comma_separated(names) + "." +
                       did_you_mean(name, names));
    }

    // muParser on a formula whose variables all have a value.
    double
    evaluate_formula(const std::string                   &formula,
                     const std::map<std::string, double> &variables)
    {
      const SilencedErrors silence;
      try
        {
          dealii::FunctionParser<1> parser(1);
          // Scalar functions of deal.II need a coordinate. No formula can
          // refer to this one, as names other than calls and functions are
          // refused.
          parser.initialize("x", formula, variables);
          return parser.value(dealii::Point<1>());
        }
      catch (const dealii::ExceptionBase &error)
        {
          std::ostringstream reason;
          error.print_info(reason);
          throw InputError("The formula cannot be read. muParser says: " +
                           trim(reason.str()));
        }
      catch (...) // muParser's own error is no std::exception
        {
          throw InputError("The formula cannot be read.");
        }
    }

    std::string
    without_word_switch(const std::string &argument)
    {
      const std::string word = "switch";
      if (argument.compare(0, word.size(), word) != 0)
        throw InputError("The second argument of time() was found as '" +
                         argument +
                         "'. It has to be the word switch and a number: "
                         "time(column > value, switch 1).");
      return trim(argument.substr(word.size()));
    }

    Condition::Comparison
    comparison(const char sign, const bool with_equality)
    {
      using Comparison = Condition::Comparison;
      if (sign == '>')
        return with_equality ? Comparison::greater_or_equal :
                               Comparison::greater;
      return with_equality ? Comparison::less_or_equal : Comparison::less;
    }

    void
    check_switch_number(const double k)
    {
      if (!(k >= 1.) || k != std::floor(k))
        throw InputError("The switches of a condition are counted 1, 2, ...; "
                         "found was switch " +
                         std::to_string(k) + ".");
    }

    double
    kth_switch(const std::vector<double> &times, const double k)
    {
      check_switch_number(k);
      if (k > times.size())
        throw NoValue("the condition switches " + std::to_string(times.size()) +
                      " times only");
      return times[static_cast<std::size_t>(k) - 1];
    }

    double
    value_at_nearest_node(const NodalField          &field,
                          const std::vector<double> &position)
    {
      dealii::Point<3> point;
      for (unsigned int d = 0; d < position.size(); ++d)
        point[d] = position[d];
      double nearest = std::numeric_limits<double>::max();
      double value   = std::numeric_limits<double>::quiet_NaN();
      for (unsigned int i = 0; i < field.points.size(); ++i)
        {
          const double distance = field.points[i].distance_square(point);
          if (distance < nearest)
            {
              nearest = distance;
              value   = field.values[i];
            }
        }
      return value;
    }

    // Of the first node with this value; NaN if there is none, since a value
    // is not a number.
    double
    coordinate_of_extreme(const NodalField  &field,
                          const unsigned int component,
                          const double       value)
    {
      const auto at =
        std::find(field.values.begin(), field.values.end(), value);
      return at == field.values.end() ?
               std::numeric_limits<double>::quiet_NaN() :
               field.points[at - field.values.begin()][component];
    }

    double
    evaluate_field(const std::string         &function,
                   const NodalField          &field,
                   const std::vector<double> &arguments)
    {
      AssertDimension(field.points.size(), field.values.size());
      if (field.values.empty())
        throw NoValue("the field has no nodes");
      // The extremes of time series have the care for NaN that is wanted here.
      const TimeSeries values{std::vector<double>(field.values.size(), 0.),
                              field.values};
      if (function == "field_max")
        return maximum(values);
      if (function == "field_min")
        return minimum(values);
      if (function != "field")
        return coordinate_of_extreme(field,
                                     function[0] - 'x',
                                     function.substr(5) == "max" ?
                                       maximum(values) :
                                       minimum(values));
      return value_at_nearest_node(field, arguments);
    }

    double
    evaluate_condition(const std::string         &function,
                       const TimeSeries          &series,
                       const Condition           &condition,
                       const std::vector<double> &arguments)
    {
      if (function == "first")
        return first_time(series, condition);
      if (function == "last")
        return last_time(series, condition);
      const std::vector<double> times = switch_times(series, condition);
      if (function == "switches")
        return times.size();
      return kth_switch(times, arguments[1]);
    }

    double
    evaluate_column(const std::string         &function,
                    const TimeSeries          &series,
                    const std::vector<double> &arguments)
    {
      if (function == "at")
        return interpolate(series, arguments[0]);
      const bool windowed = !arguments.empty();
      if (windowed && !(arguments[0] <= arguments[1]))
        throw NoValue("the time window ends before it begins");
      if (function == "mean")
        return mean(
          windowed ? part_between(series, arguments[0], arguments[1]) : series);
      const TimeSeries rows =
        windowed ? rows_between(series, arguments[0], arguments[1]) : series;
      if (function == "max")
        return maximum(rows);
      if (function == "min")
        return minimum(rows);
      if (function == "max_abs")
        return maximum_absolute(rows);
      return final_value(rows);
    }
  } // namespace



  CheckExpression::CheckExpression(const std::string &text,
                                   const Constants   &constants)
  {
    if (trim(text).empty())
      throw InputError("A formula is missing.");
    // Calls inside of each other would fill the stack.
    constexpr std::size_t longest = 10000;
    if (text.size() > longest)
      throw InputError("A formula has " + std::to_string(text.size()) +
                       " characters, allowed are " + std::to_string(longest) +
                       ".");
    find_outside(text, ""); // the parentheses match

    std::map<std::string, double> dummy_values;
    for (std::size_t i = 0; i < text.size();)
      {
        const std::size_t name_end = i + name_length(text, i);
        if (name_end == i)
          {
            const std::size_t length =
              std::max<std::size_t>(number_length(text, i), 1);
            formula += text.substr(i, length);
            i += length;
            continue;
          }

        const std::string name    = text.substr(i, name_end - i);
        const std::size_t open    = text.find_first_not_of(" \t", name_end);
        const bool        is_call = open < text.size() && text[open] == '(';
        if (is_call && functions().count(name) > 0)
          {
            const std::size_t close    = closing_parenthesis(text, open);
            const std::string variable = "call_" + std::to_string(calls.size());
            calls.push_back(parse_call(name,
                                       text.substr(open + 1, close - open - 1),
                                       constants));
            formula += variable;
            dummy_values[variable] = 1.;
            i                      = close + 1;
          }
        else if (is_call)
          {
            formula += name;
            i = name_end;
          }
        else
          {
            formula += "(" + shortest_exact(constant(name, constants)) + ")";
            i = name_end;
          }
      }
    evaluate_formula(formula, dummy_values);
  }



  CheckExpression::Call
  CheckExpression::parse_call(const std::string &name,
                              const std::string &arguments,
                              const Constants   &constants)
  {
    const Function          &function = functions().at(name);
    std::vector<std::string> parts    = split_outside(arguments, ',');
    const unsigned int       n        = parts.size() - 1;
    if (parts[0].empty() || std::count(function.n_arguments.begin(),
                                       function.n_arguments.end(),
                                       n) == 0)
      throw InputError("The arguments of " + name + "(" + arguments +
                       ") are not understood. Allowed is " + function.usage +
                       ".");

    Call call;
    call.function = name;
    call.subject  = parts[0];
    if (function.subject == Subject::condition)
      {
        const std::vector<std::size_t> signs = find_outside(parts[0], "<>");
        if (signs.size() != 1)
          throw InputError("'" + parts[0] +
                           "' is not a condition. Allowed is " +
                           function.usage + ", with >, <, >= or <=.");
        const std::size_t sign          = signs[0];
        const bool        with_equality = parts[0][sign + 1] == '=';
        call.comparison = comparison(parts[0][sign], with_equality);
        call.subject    = trim(parts[0].substr(0, sign));
        call.arguments.emplace_back(parts[0].substr(sign +
                                                    (with_equality ? 2 : 1)),
                                    constants);
      }
    if (name == "time")
      parts[1] = without_word_switch(parts[1]);
    for (unsigned int i = 1; i < parts.size(); ++i)
      call.arguments.emplace_back(parts[i], constants);
    if (name == "time" && call.arguments[1].is_constant())
      check_switch_number(call.arguments[1].evaluate(History(), NoFields()));
    return call;
  }



  bool
  CheckExpression::is_constant() const
  {
    return calls.empty();
  }



  void
  CheckExpression::check_names(const History     &history,
                               const FieldLookup &fields) const
  {
    for (const Call &call : calls)
      {
        if (functions().at(call.function).subject == Subject::field)
          {
            const std::vector<std::string> names = fields.names();
            if (std::count(names.begin(), names.end(), call.subject) == 0)
              throw InputError(
                "There is no field '" + call.subject + "'. " +
                list_of_names(call.subject, relatives(call.subject, names)));
          }
        else
          history.column_index(call.subject);
        for (const CheckExpression &argument : call.arguments)
          argument.check_names(history, fields);
      }
  }



  double
  CheckExpression::evaluate(const History     &history,
                            const FieldLookup &fields) const
  {
    check_names(history, fields);
    std::map<std::string, double> variables;
    for (unsigned int i = 0; i < calls.size(); ++i)
      variables["call_" + std::to_string(i)] =
        evaluate_call(calls[i], history, fields);
    return evaluate_formula(formula, variables);
  }



  double
  CheckExpression::evaluate_call(const Call        &call,
                                 const History     &history,
                                 const FieldLookup &fields)
  {
    std::vector<double> arguments;
    for (const CheckExpression &argument : call.arguments)
      arguments.push_back(argument.evaluate(history, fields));

    const Subject subject = functions().at(call.function).subject;
    if (subject == Subject::field)
      return evaluate_field(call.function,
                            fields.field(call.subject),
                            arguments);

    const TimeSeries series{history.times(), history.values(call.subject)};
    if (subject == Subject::condition)
      return evaluate_condition(call.function,
                                series,
                                Condition{call.comparison, arguments[0]},
                                arguments);
    return evaluate_column(call.function, series, arguments);
  }
} // namespace Signorini
