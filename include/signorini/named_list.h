#ifndef signorini_named_list_h
#define signorini_named_list_h

#include <deal.II/base/point.h>

#include <string>
#include <vector>

namespace Signorini
{
  /** One item `name: value` of a list in the .prm. */
  struct NamedItem
  {
    std::string name;
    std::string value;
  };

  /**
   * Splits `a: x | b: y` into its items. Empty text gives an empty list.
   * @param entry the path of the entry, for messages
   * @throws InputError for an item without colon, name or value.
   */
  std::vector<NamedItem>
  parse_named_list(const std::string &text, const std::string &entry);

  /** Splits at the separator and trims; empty text gives an empty list. */
  std::vector<std::string>
  split_list(const std::string &text, const char separator);

  /** A component x, y (, z) as its number. @throws InputError otherwise. */
  template <int dim>
  unsigned int
  parse_component(const std::string &text, const std::string &entry);

  /** The name of a component: x, y or z. */
  std::string
  component_name(const unsigned int component);

  /**
   * A number, or a constant expression such as 2*pi/3.
   * @throws InputError otherwise.
   */
  double
  parse_number(const std::string &text, const std::string &entry);

  /** `x, y (, z)` as a point. @throws InputError otherwise. */
  template <int dim>
  dealii::Point<dim>
  parse_point(const std::string &text, const std::string &entry);
} // namespace Signorini

#endif
