#ifndef signorini_input_parameter_json_h
#define signorini_input_parameter_json_h

#include <signorini/input/declared_parameters.h>

#include <string>

namespace Signorini
{
  /**
   * Sections and entries as JSON, in the form of deal.II's ParameterHandler:
   * an entry is an object with its value, default_value, documentation and
   * pattern_description. That of deal.II 9.4 breaks names at their dots, and
   * pairs in contact have dots.
   */
  std::string
  parameter_json(const DeclaredSection &section);
} // namespace Signorini

#endif
