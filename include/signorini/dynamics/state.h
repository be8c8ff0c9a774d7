#ifndef signorini_dynamics_state_h
#define signorini_dynamics_state_h

#include <signorini/linear_algebra/types.h>
#include <signorini/variational_inequality/interface_problem.h>

#include <boost/serialization/array.hpp>
#include <boost/serialization/vector.hpp>

#include <array>
#include <vector>

namespace Signorini
{
  /**
   * Where energy is and where it came from since t = 0, in J (2-D: with the
   * thickness). The sum of the works on the right equals what is kept on the
   * left up to what the time integration loses,
   *   kinetic + stored + plastic + damping + friction + scheme_loss
   *     = initial + loads + supports + contact + returned.
   */
  struct EnergyLedger
  {
    double initial  = 0.; // kinetic + stored at t = 0
    double kinetic  = 0.; // 1/2 V.M V
    double stored   = 0.; // strain energy
    double plastic  = 0.; // plastic work
    double loads    = 0.; // work of the loads
    double supports = 0.; // work of prescribed motions
    double contact  = 0.; // of the contact forces, but for friction
    double returned = 0.; // given back for contacts that opened or closed
    double damping  = 0.; // taken by Rayleigh damping
    double friction = 0.; // taken by slip

    /** What the time integration lost; negative: made. */
    double
    scheme_loss() const
    {
      return initial + loads + supports + contact + returned - damping -
             friction - plastic - kinetic - stored;
    }

    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int /*version*/)
    {
      archive &initial &kinetic &stored &plastic &loads &supports &contact
        &returned &damping &friction;
    }
  };

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
    DofVector           displacement;      // U, m
    DofVector           velocity;          // V, m/s; static: of the step
    DofVector           acceleration;      // A, m/s^2
    DofVector           internal_force;    // F_int(U), N
    DofVector           external_force;    // F(t), N
    DofVector           support_force;     // at given unknowns, N
    std::vector<double> history;           // of all material points
    InterfaceForces     contact_forces;    // of each candidate, N
    std::vector<double> gaps;              // g_k of each candidate, m
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

    // Slip of each candidate since it closed (m), its rate over the last step
    // (m/s), whether it slipped in that step, and the way that it went since it
    // stuck (m).
    std::vector<std::array<double, 2>> slips;
    std::vector<double>                slip_rates;
    std::vector<double>                slip_ways;
    std::vector<char>                  is_slipping;

    // How the step that led here was solved.
    unsigned int n_iterations = 0;
    double       residual     = 0.; // unbalanced force over the largest force
    double       kkt_residual = 0.; // of the last interface problem

    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int /*version*/)
    {
      archive &time &step &displacement &velocity &acceleration;
      archive &internal_force &external_force     &support_force;
      archive                                     &history;
      archive &contact_forces.normal        &contact_forces.tangential;
      archive &gaps &contact_debt           &energy;
      archive &massless_nodes &keeps_mass   &motions;
      archive &slips &slip_rates &slip_ways &is_slipping;
      archive &n_iterations &residual       &kkt_residual;
    }
  };
} // namespace Signorini

#endif
