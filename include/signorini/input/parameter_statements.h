#ifndef signorini_input_parameter_statements_h
#define signorini_input_parameter_statements_h

#include <string>
#include <vector>

namespace Signorini
{
  /**
   * One statement of a .prm: `set entry = value` inside the nested
   * subsections `section`, or the opening of the last one of them.
   */
  struct ParameterStatement
  {
    /** Names of the subsections around the statement, outermost first. */
    std::vector<std::string> section;

    /** Name of the entry; empty when the statement opens `section`. */
    std::string entry;

    /** The text after "=", without comment and outer blanks. */
    std::string value;

    /** Where it stands: "prm/beam.prm:12", or "--set". */
    std::string origin;
  };

  /**
   * All statements of a file and of the files it includes, in the order in
   * which they are read. The syntax is that of dealii::ParameterHandler:
   * `subsection NAME`, `end`, `set NAME = VALUE`, `include FILE` (relative to
   * the file that includes it), comments from # to the end of the line, and a
   * backslash at the end of a line that goes on in the next one. Blanks at the
   * beginning of that next line do not count.
   *
   * @throws InputError for a file that is missing, cannot be read or includes
   * itself, and for lines that are no statement; the message starts with
   * "file:line:".
   */
  std::vector<ParameterStatement>
  read_parameter_statements(const std::string &path);

  /** Section names joined for a message: "Body beam / Material". */
  std::string
  section_in_words(const std::vector<std::string> &section);

  /** Without blanks at both ends, and with single blanks inside. */
  std::string
  without_extra_blanks(const std::string &text);
} // namespace Signorini

#endif
