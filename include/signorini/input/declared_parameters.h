#ifndef signorini_input_declared_parameters_h
#define signorini_input_declared_parameters_h

#include <deal.II/base/parameter_handler.h>

#include <string>
#include <utility>
#include <vector>

namespace Signorini
{
  /**
   * What a ParameterHandler knows in one subsection and below, in the order
   * of declaration. The handler itself does not tell.
   */
  struct DeclaredSection
  {
    struct Entry
    {
      std::string name;

      /** Machine description of the pattern of the value. */
      std::string pattern;

      std::string value;
      std::string default_value;
      std::string documentation;
    };

    std::vector<Entry> entries;

    std::vector<std::pair<std::string, DeclaredSection>> sections;

    /** The entry with this name, or null. */
    const Entry *
    find_entry(const std::string &name) const;

    /** The subsection with this name, or null. */
    const DeclaredSection *
    find_section(const std::string &name) const;

    std::vector<std::string>
    entry_names() const;

    std::vector<std::string>
    section_names() const;
  };

  /** Everything that was declared, from the top. */
  DeclaredSection
  declared_parameters(const dealii::ParameterHandler &prm);
} // namespace Signorini

#endif
