#ifndef signorini_input_parameter_reference_h
#define signorini_input_parameter_reference_h

#include <signorini/input/declared_parameters.h>
#include <signorini/input/unread_entries.h>

#include <optional>
#include <string>
#include <vector>

namespace Signorini
{
  /** What problems of one kind declare, and which of it is read when. */
  struct DeclaredProblem
  {
    DeclaredSection parameters;
    ConditionList   conditions;
  };

  /** What makes an entry count, such as `Set Law = elasto-plastic'. */
  struct Remedies
  {
    std::vector<std::string> in_2d, in_3d;
  };

  /** An entry of plane or axisymmetric problems, of 3-D ones, or of both. */
  struct ReferenceEntry
  {
    std::string name;

    std::optional<DeclaredSection::Entry> in_2d, in_3d;

    Remedies remedies;
  };

  /** A section without those inside it. */
  struct ReferenceSection
  {
    /** From the top; empty for the top itself. */
    std::vector<std::string> path;

    bool is_in_2d = false, is_in_3d = false;

    /** Of all entries of the section. */
    Remedies remedies;

    std::vector<ReferenceEntry> entries;
  };

  /**
   * Every section of both kinds of problems, each before those inside it, in
   * the order of declaration; those of 3-D only come after the others of the
   * section around.
   */
  std::vector<ReferenceSection>
  parameter_reference(const DeclaredProblem &plane,
                      const DeclaredProblem &spatial);

  /** Whether the sections declare the same entries. */
  bool
  have_same_entries(const ReferenceSection &first,
                    const ReferenceSection &second);

  /** The end of a documentation, `Unit: m.', taken apart from the rest. */
  struct TextWithUnit
  {
    std::string text;
    std::string unit; // empty without one
  };

  TextWithUnit
  split_unit(const std::string &documentation);
} // namespace Signorini

#endif
