#ifndef signorini_dynamics_step_contact_h
#define signorini_dynamics_step_contact_h

#include <signorini/contact/contact_model.h>
#include <signorini/dynamics/state.h>
#include <signorini/linear_algebra/types.h>

#include <vector>

namespace Signorini
{
  /**
   * The contact forces of a step and the work that they do over its motion dU.
   *
   *   w A_n^T lambda_n . dU + (1 - w) A_np^T lambda_np . dU,
   *
   * each force with the normals of its own end. Where nodes have no mass,
   * forces are in balance at both ends of the step, and w = 1/2. Where they
   * have, those of the end act in the weighted balance, and the velocity gets
   * from those of the start what Newmark's formula keeps of the old
   * acceleration: w = (1 - gamma - alpha_B)/(1 - alpha_B).
   */
  template <int dim>
  class StepContact
  {
  public:
    /** All but the old points must outlive the object.
     * @param old_points where the contacts were at the start; read where forces
     *                   acted then
     * @param old_share w, in [0, 1/2] */
    StepContact(const ContactModel<dim>              &contact,
                const State                          &old_state,
                std::vector<ContactPoint<dim>>        old_points,
                const State                          &state,
                const std::vector<ContactPoint<dim>> &points,
                const double                          old_share);

    /** Work of all contact forces, J. */
    double
    work() const;

    /** tau . slip of all contacts, negative in general, J. */
    double
    tangential_work() const;

    /** What slip takes from the bodies, of no contact less than nothing, J. */
    double
    friction() const;

    /** What contact forces do as worn surfaces recede: taken from the bodies,
     * J. */
    double
    wear() const;

    /**
     * The work that is none in the continuous problem: of forces between bodies
     * all but friction, since they are pairs; of a target with a given motion
     * lambda (g_np - g_n), what is not done by that motion. Zero but where a
     * contact opens or closes, and what directions change by in the step. J.
     */
    double
    undue_work() const;

    /** Normal forces as they act in the step, N. */
    InterfaceForces
    normal_forces() const;

  private:
    // Work of the forces of a contact at one end, but for friction.
    double
    pair_work(const double                          share,
              const State                          &state,
              const std::vector<ContactPoint<dim>> &points,
              const unsigned int                    k) const;

    double old_share_, share_; // w, 1 - w

    const ContactModel<dim>              &contact_;
    const State                          &old_state_;
    const std::vector<ContactPoint<dim>>  old_points_;
    const State                          &state_;
    const std::vector<ContactPoint<dim>> &points_;
    DofVector                             motion_; // m
  };
} // namespace Signorini

#endif
