#ifndef signorini_solid_rigid_body_dof_h
#define signorini_solid_rigid_body_dof_h

#include <functional>

namespace Signorini
{
  /**
   * An unknown of a rigid body: a displacement of its centre, or its rotation
   * times a length. Nothing but contact couples it to others.
   */
  struct RigidBodyDof
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
