#ifndef signorini_dynamics_state_h
#define signorini_dynamics_state_h

#include <signorini/contact/contact_state.h>
#include <signorini/contact/contact_target.h>
#include <signorini/dynamics/energy_ledger.h>
#include <signorini/linear_algebra/types.h>

#include <boost/serialization/array.hpp>
#include <boost/serialization/vector.hpp>

#include <array>
#include <vector>

namespace Signorini
{
  /** How a body moves as a whole. Components that a formulation does not have
   * are zero. */
  struct BodyMotion
  {
    using Vector3 = std::array<double, 3>;

    Vector3 momentum         = {{0., 0., 0.}}; // sum M V, kg m/s
    Vector3 angular_momentum = {{0., 0., 0.}}; // sum x x M V, origin, kg m^2/s
    Vector3 centre           = {{0., 0., 0.}}; // of mass, m

    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int /*version*/)
    {
      archive &momentum &angular_momentum &centre;
    }
  };

  /**
   * Everything a run knows at one time. A value: it can be copied, thrown away
   * and serialised. A step that is cut goes back to the old one.
   */
  struct State
  {
    double              time = 0.; // s
    unsigned int        step = 0;
    DofVector           displacement;   // U, m
    DofVector           velocity;       // V, m/s; static: of the step
    DofVector           acceleration;   // A, m/s^2
    DofVector           internal_force; // F_int(U), N
    DofVector           external_force; // F(t), N
    DofVector           support_force;  // at given unknowns, N
    std::vector<double> history;        // of all material points
    ContactState        contact;
    double              contact_debt = 0.; // work still to be returned, J
    EnergyLedger        energy;

    // Nodes without mass, by their first unknown, in ascending order.
    std::vector<unsigned int> massless_nodes;

    // True after nodes got their mass back: none loses it again.
    bool keeps_mass = false;

    // F - F_int of nodes that lost their mass at the start of the step, N. It
    // went with their mass. Empty at the end of a step.
    DofVector handed_over;

    // Of the bodies and of the free rigid bodies, in a dynamic run.
    std::vector<BodyMotion> motions;

    // How the step that led here was solved.
    unsigned int n_iterations = 0;
    double       residual     = 0.; // unbalanced force over the largest force
    double       kkt_residual = 0.; // of the last interface problem

    /** Where all is. A view of this state. */
    Configuration
    configuration() const
    {
      return {displacement, time, &contact};
    }

    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int /*version*/)
    {
      archive &time &step &displacement &velocity &acceleration;
      archive &internal_force &external_force     &support_force;
      archive &history                            &contact;
      archive &contact_debt                       &energy;
      archive &massless_nodes &keeps_mass         &motions;
      archive &n_iterations &residual             &kkt_residual;
    }
  };
} // namespace Signorini

#endif
