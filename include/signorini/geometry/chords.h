#ifndef signorini_geometry_chords_h
#define signorini_geometry_chords_h

#include <signorini/geometry/mesh.h>

#include <string>

namespace Signorini
{
  /** What the faces of a boundary look like, in the coarsest mesh. */
  struct Chords
  {
    // The largest angle from one face to the next; zero unless most faces turn
    // smoothly, by half a degree to the feature angle, as the chords of a curve
    // do, and know no curve on which new nodes would be put. degrees
    double turn = 0.;

    bool are_cut = false; // by refinements: their new nodes are on the chords
  };

  /**
   * Meshes from files are straight between their nodes; those of a generator
   * know their curves.
   * @param boundary      its name
   * @param feature_angle more is a corner, degrees
   */
  template <int dim>
  Chords
  find_chords(const Mesh<dim>   &mesh,
              const std::string &boundary,
              const double       feature_angle);
} // namespace Signorini

#endif
