#ifndef signorini_run_mesh_warnings_h
#define signorini_run_mesh_warnings_h

#include <signorini/run/problem.h>

#include <string>

namespace Signorini
{
  /**
   * A line for each boundary of a contact pair that comes from a file as the
   * chords of a curve and gets new nodes between those of the file, by
   * refinements, Adaptivity or elements of a higher degree: they lie on the
   * chords, and their contact pressure shows it.
   */
  template <int dim>
  std::string
  mesh_warnings(const Problem<dim> &problem);
} // namespace Signorini

#endif
