#ifndef signorini_run_reference_text_h
#define signorini_run_reference_text_h

#include <signorini/input/parameter_reference.h>
#include <signorini/input/text_format.h>

#include <map>
#include <string>
#include <vector>

namespace Signorini
{
  /** A picture of a generated mesh and the names of its boundaries. */
  struct BoundarySketch
  {
    /** Relative to the folder of the text. */
    std::string file;

    /** For which problems, and with which entries. */
    std::string caption;

    std::vector<std::string> boundaries;
  };

  /** Name of the subsection of a generator -> its sketches. */
  using BoundarySketches = std::map<std::string, std::vector<BoundarySketch>>;

  /** All sections as a document. */
  std::string
  reference_text(const std::vector<ReferenceSection> &sections,
                 const BoundarySketches              &sketches,
                 const TextFormat                    &format);
} // namespace Signorini

#endif
