#include <signorini/input_error.h>
#include <signorini/named_list.h>
#include <signorini/nearest_name.h>
#include <signorini/silenced_errors.h>
#include <signorini/space_time_function.h>

#include <deal.II/base/numbers.h>

#include <cctype>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    bool
    contains_identifier(const std::string &text, const std::string &name)
    {
      const auto belongs_to_name = [](const char c) {
        return std::isalnum(static_cast<unsigned char>(c)) || c == '_';
      };
      for (std::size_t at = text.find(name); at != std::string::npos;
           at             = text.find(name, at + 1))
        {
                      const std::size_t end = at + name.size();
                      if ((at == 0 || !belongs_to_name(text[at - 1])) &&
              (end == text.size() || !belongs_to_name(text[end])))
            return true;
        }
      return false;
    }

    template <int dim>
    std::string
    variables()
    {
      return dim == 2 ? "x,y,t" : "x,y,z,t";
    }
  } // namespace



  Constants
  parse_constants(const std::string &text, const std::string &entry)
  {
    Constants constants = {{"pi", numbers::PI}};
    for (const std::string &item : split_list(text, ','))
      {
        const std::size_t equal = item.find('=');
        const std::string name  = Utilities::trim(item.substr(0, equal));
        if (equal == std::string::npos || name.empty() || name == "t" ||
            name == "x" || name == "y" || name == "z" ||
            !(std::isalpha(static_cast<unsigned char>(name[0]))))
          throw InputError(entry + ": found \"" + item +
                           "\". Write \"name = number\" with commas between, "
                           "and names other than x, y, z, t.");
        constants[name] = parse_number(item.substr(equal + 1), entry);
      }
    return constants;
  }



  template <int dim>
  SpaceTimeFunction<dim>::SpaceTimeFunction(const std::string &text,
                                            const unsigned int n_components,
                                            const Constants   &constants,
                                            const std::string &entry)
    : function_(std::make_unique<FunctionParser<dim>>(n_components))
    , depends_on_time_(contains_identifier(text, "t"))
  {
    const auto expressions = split_list(text, ';');
    if (expressions.size() != n_components)
      throw InputError(entry + ": found " + std::to_string(expressions.size()) +
                       " expression(s) in \"" + text + "\", expected " +
                       std::to_string(n_components) +
                       ", separated by semicolons.");
    const SilencedErrors silence;
    try
      {
        function_->initialize(variables<dim>(), expressions, constants, true);
        for (unsigned int c = 0; c < n_components; ++c)
          value(Point<dim>(), 0., c);
      }
    catch (const ExceptionBase &error)
      {
        std::ostringstream reason;
        error.print_info(reason);
        std::vector<std::string> names;
        for (const auto &[name, number] : constants)
          names.push_back(name);
        throw InputError(entry + ": cannot read the expression \"" + text +
                         "\". Allowed are the variables " + variables<dim>() +
                         ", the constants " + comma_separated(names) +
                         " (more of them: entry Constants), and muParser's "
                         "operators and functions. " +
                         Utilities::trim(reason.str()));
      }
  }



  template <int dim>
  double
  SpaceTimeFunction<dim>::value(const Point<dim>  &point,
                                const double       time,
                                const unsigned int component) const
  {
    function_->set_time(time);
    return function_->value(point, component);
  }



  template <int dim>
  Tensor<1, dim>
  SpaceTimeFunction<dim>::vector_value(const Point<dim> &point,
                                       const double      time) const
  {
    Tensor<1, dim> result;
    for (unsigned int c = 0; c < dim; ++c)
      result[c] = value(point, time, c);
    return result;
  }



  template class SpaceTimeFunction<2>;
  template class SpaceTimeFunction<3>;
} // namespace Signorini
