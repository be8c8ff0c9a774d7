#ifndef signorini_run_history_columns_h
#define signorini_run_history_columns_h

#include <signorini/dynamics/state.h>
#include <signorini/output/history.h>
#include <signorini/run/problem.h>

namespace Signorini
{
  /** Number of candidates that carry a contact force. */
  unsigned int
  n_active_contacts(const State &state);

  /**
   * Appends the columns of a run:
   *  - iterations, residual, kkt_residual of the step;
   *  - MONITOR.displacement_x, ..., MONITOR.velocity_x, ...;
   *  - for each pair: contacts (nodes with contact force), force_x, ... (on
   *    the body), pressure_max and pressure_mean (contact force over the area
   *    of the nodes in contact), gap_min, penetration = max(0, -gap_min);
   *  - for each free rigid body: displacement, velocity, and in a dynamic run
   *    momentum and angular momentum;
   *  - for each body of a dynamic run: momentum_x, ..., angular_momentum (3-D:
   *    _x, ...), centre_x, ...; of an axisymmetric one only along the axis;
   *  - energy.kinetic, .stored, .damping, .scheme_loss; work.loads, .supports,
   *    .contact, .returned.
   */
  template <int dim>
  void
  add_history_columns(const Problem<dim> &problem, History &history);

  /** Appends the row of a state, in the order of add_history_columns(). */
  template <int dim>
  void
  append_history_row(const Problem<dim> &problem,
                     const State        &state,
                     History            &history);
} // namespace Signorini

#endif
