#include <signorini/input/as_text.h>
#include <signorini/input/input_error.h>
#include <signorini/input/instantiate.h>
#include <signorini/input/named_list.h>

#include <deal.II/base/utilities.h>

#include <cmath>

namespace Signorini
{
  using namespace dealii;

  std::vector<std::string>
  split_list(const std::string &text, const char separator)
  {
    if (Utilities::trim(text).empty())
      return {};
    std::vector<std::string> items(1);
    int                      depth = 0; // of parentheses
    for (const char c : text)
      if (c == separator && depth <= 0)
        items.emplace_back();
      else
        {
          depth += c == '(' ? 1 : c == ')' ? -1 : 0;
          items.back() += c;
        }
    for (std::string &item : items)
      item = Utilities::trim(item);
    return items;
  }



  std::vector<NamedItem>
  parse_named_list(const std::string &text, const std::string &entry)
  {
    std::vector<NamedItem> items;
    for (const std::string &item : split_list(text, '|'))
      {
        const std::size_t colon = item.find(':');
        if (colon == std::string::npos)
          throw InputError(entry,
                           "found \"" + item +
                             "\", which has no colon. Write \"name: value\", "
                             "and \" | \" between two of them.");
        const NamedItem named = {Utilities::trim(item.substr(0, colon)),
                                 Utilities::trim(item.substr(colon + 1))};
        if (named.name.empty() || named.value.empty())
          throw InputError(
            entry,
            "found \"" + item +
              "\", where the name or the value is empty. Write "
              "\"name: value\", and \" | \" between two of them.");
        items.push_back(named);
      }
    return items;
  }



  std::string
  component_name(const unsigned int component)
  {
    return std::string(1, static_cast<char>('x' + component));
  }



  template <int dim>
  unsigned int
  parse_component(const std::string &text, const std::string &entry)
  {
    for (unsigned int c = 0; c < dim; ++c)
      if (text == component_name(c))
        return c;
    throw InputError(entry,
                     "found component \"" + text + "\", allowed are x, y" +
                       (dim == 3 ? ", z." : "."));
  }



  bool
  is_sane(const double value)
  {
    const double magnitude = std::abs(value);
    return value == 0. || (magnitude >= 1e-100 && magnitude <= 1e100);
  }



  double
  parse_number(const std::string &text,
               const std::string &entry,
               const Constants   &constants)
  {
    const std::string found = "found \"" + Utilities::trim(text) + "\", ";
    double            value = 0.;
    try
      {
        value = Formula(text, {}, constants, entry).value({});
      }
    catch (const InputError &error)
      {
        throw InputError(entry,
                         found +
                           "expected a number or a constant expression. " +
                           as_sentence(error.text()));
      }
    if (!is_sane(value))
      throw InputError(entry, found + sane_magnitudes + ".");
    return value;
  }



  template <int dim>
  Point<dim>
  parse_point(const std::string &text,
              const std::string &entry,
              const Constants   &constants)
  {
    const auto coordinates = split_list(text, ',');
    if (coordinates.size() != dim)
      throw InputError(entry,
                       "found \"" + text + "\", expected " +
                         std::to_string(dim) +
                         " coordinates in m, separated by commas.");
    Point<dim> point;
    for (unsigned int d = 0; d < dim; ++d)
      point[d] = parse_number(coordinates[d], entry, constants);
    return point;
  }



#define INSTANTIATE(dim)                                           \
  template unsigned int parse_component<dim>(const std::string &,  \
                                             const std::string &); \
  template Point<dim>   parse_point<dim>(const std::string &,      \
                                       const std::string &,      \
                                       const Constants &);
  SIGNORINI_FOR_EACH_DIMENSION(INSTANTIATE)
#undef INSTANTIATE
} // namespace Signorini
