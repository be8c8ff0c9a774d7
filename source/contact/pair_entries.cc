#include <signorini/contact/pair_entries.h>
#include <signorini/input/input_error.h>
#include <signorini/input/named_list.h>

#include <deal.II/base/parameter_handler.h>

namespace Signorini
{
  using namespace dealii;

  void
  declare_pair_entry(const std::string           &name,
                     const std::string           &default_value,
                     const std::string           &documentation,
                     const bool                   in_pair,
                     ParameterHandler            &prm,
                     const Patterns::PatternBase &pattern)
  {
    prm.declare_entry(name,
                      in_pair ? "" : default_value,
                      pattern,
                      in_pair ?
                        "As in Contact, for this pair. Empty: as there." :
                        documentation);
  }



  double
  parse_not_negative(const PairEntries &entries, const std::string &name)
  {
    const std::string text  = entries.get(name);
    const double      value = parse_number(text, entries.path(name));
    if (!(value >= 0.))
      throw InputError(entries.path(name),
                       "found " + text + ", but it must not be negative.");
    return value;
  }



  double
  parse_positive(const PairEntries &entries, const std::string &name)
  {
    const std::string text  = entries.get(name);
    const double      value = parse_number(text, entries.path(name));
    if (!(value > 0.))
      throw InputError(entries.path(name),
                       "found " + text + ", but it must be greater than zero.");
    return value;
  }
} // namespace Signorini
