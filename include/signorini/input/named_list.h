#ifndef signorini_input_named_list_h
#define signorini_input_named_list_h

#include <signorini/input/formula.h>

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

  /**
   * Splits at the separator outside of parentheses, and trims; empty text
   * gives an empty list.
   */
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
   * Whether a number of the .prm is 0 or from 1e-100 to 1e100 in magnitude:
   * squares and products of others neither overflow nor vanish.
   */
  bool
  is_sane(const double value);

  /** That in words, for messages. */
  constexpr const char *sane_magnitudes =
    "allowed are 0 and magnitudes from 1e-100 to 1e100";

  /**
   * A number, or an expression in constants such as 2*pi/3.
   * @throws InputError otherwise, or if it is not sane.
   */
  double
  parse_number(const std::string &text,
               const std::string &entry,
               const Constants   &constants = only_pi());

  /** `x, y (, z)` as a point. @throws InputError otherwise. */
  template <int dim>
  dealii::Point<dim>
  parse_point(const std::string &text,
              const std::string &entry,
              const Constants   &constants = only_pi());
} // namespace Signorini

#endif
