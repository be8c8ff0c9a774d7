#ifndef signorini_run_reference_h
#define signorini_run_reference_h

#include <string>

namespace Signorini
{
  /**
   * Writes what every entry of a .prm means, in two and in three dimensions,
   * to a folder:
   *
   * - reference.md and reference.html, with defaults, units, allowed values,
   *   links to the manual, and the boundaries of generated meshes;
   * - sketches/, pictures of these (SVG);
   * - parameters_2d and _3d, .xml for deal.II's parameter_gui and .json for
   *   editors.
   *
   * The files depend on the program only.
   * @throws InputError with the reason when the folder cannot be written to.
   */
  void
  write_reference(const std::string &folder);
} // namespace Signorini

#endif
