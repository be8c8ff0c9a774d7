#ifndef signorini_geometry_mesh_examples_h
#define signorini_geometry_mesh_examples_h

#include <signorini/geometry/mesh.h>

#include <map>
#include <string>
#include <vector>

namespace Signorini
{
  /** Settings of a generator that show its mesh and its boundaries. */
  struct MeshExample
  {
    /** Name of the generator in the .prm. */
    std::string generator;

    /** What decides which boundaries there are: `Part = full'; may be empty. */
    std::string variant;

    /** Entries of the generator's subsection that have another value. */
    std::map<std::string, std::string> entries;
  };

  /**
   * At least one example for each generator that needs no file: one for each
   * set of boundaries that it makes. They are coarse.
   */
  template <int dim>
  std::vector<MeshExample>
  mesh_examples();

  /** The mesh of an example. */
  template <int dim>
  Mesh<dim>
  create_example(const MeshExample &example);
} // namespace Signorini

#endif
