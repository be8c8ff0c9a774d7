#ifndef signorini_simulation_step_contact_h
#define signorini_simulation_step_contact_h

#include <signorini/contact/contact_model.h>
#include <signorini/simulation/state.h>

#include <vector>

namespace Signorini
{
  /**
   * The contact forces of a step and the work that they do over its motion dU.
   *
   * Where nodes have no mass, forces are in balance at both ends of the step,
   * and work is that of the trapezoidal rule, each force with the normals of
   * its own end:
   *   1/2 (A_n^T lambda_n + A_np^T lambda_np) . dU.
   * Where they have, those of the end act throughout: A_np^T lambda_np . dU.
   */
  template <int dim>
  class StepContact
  {
  public:
    /** All but the old points must outlive the object.
     * @param old_points where the contacts were at the start; read where forces
     *                   acted then
     * @param acts_at_both_ends or as at its end throughout */
    StepContact(const ContactModel<dim>              &contact,
                const State                          &old_state,
                std::vector<ContactPoint<dim>>        old_points,
                const State                          &state,
                const std::vector<ContactPoint<dim>> &points,
                const bool                            acts_at_both_ends);

    /** Work of all contact forces, J. */
    double
    work() const;

    /** tau . slip of all contacts, negative in general, J. */
    double
    tangential_work() const;

    /** What slip takes from the bodies, of no contact less than nothing, J. */
    double
    friction() const;

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

    // Share of a force of the start and of the end in the step.
    double old_share_, share_;

    const ContactModel<dim>              &contact_;
    const State                          &old_state_;
    const std::vector<ContactPoint<dim>>  old_points_;
    const State                          &state_;
    const std::vector<ContactPoint<dim>> &points_;
    dealii::Vector<double>                motion_; // m
  };
} // namespace Signorini

#endif
