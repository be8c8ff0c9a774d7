#ifndef signorini_solid_lumped_unknown_h
#define signorini_solid_lumped_unknown_h

#include <functional>

namespace Signorini
{
  /**
   * An unknown with a mass of its own that belongs to no mesh, such as a
   * displacement of a rigid body. Nothing but contact couples it to others.
   */
  struct LumpedUnknown
  {
    double mass             = 0.; // kg
    double initial_velocity = 0.; // m/s

    // External force at a time, N.
    std::function<double(const double)> force;

    // Given displacement at a time, m; none: it is solved for.
    std::function<double(const double)> motion;
  };
} // namespace Signorini

#endif
