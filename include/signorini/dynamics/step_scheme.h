#ifndef signorini_dynamics_step_scheme_h
#define signorini_dynamics_step_scheme_h

#include <signorini/time/generalized_alpha.h>
#include <signorini/time/time_parameters.h>

namespace Signorini
{
  /**
   * How motion and contact forces are integrated over a step. On massless nodes
   * contact forces act as loads do, with the weight of the new state; on nodes
   * with mass they are fully implicit.
   */
  struct StepScheme
  {
    GeneralizedAlpha bodies;

    // Rigid bodies stand against massless nodes, which are in balance at the
    // end of the step. Their own method is of second order, as that of the
    // bodies, needs no old contact force, and lets nothing ring when nodes
    // land. Where every node has mass it is that of the bodies.
    GeneralizedAlpha rigid_bodies;

    // What the multiplier of the interface problem is of the contact force, 1.
    double multiplier_factor;

    // What the multiplier is of the contact force that acts on a rigid body in
    // its method, inverted: 1 over the scale of the rows of rigid bodies.
    double rigid_share;

    // Of the old contact forces in the work of a step, see StepContact.
    double old_contact_share;
  };

  /** @param keeps_mass the nodes got back the mass that @p time takes */
  StepScheme
  step_scheme(const TimeParameters &time, const bool keeps_mass);
} // namespace Signorini

#endif
