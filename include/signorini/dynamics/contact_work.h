#ifndef signorini_dynamics_contact_work_h
#define signorini_dynamics_contact_work_h

#include <signorini/contact/contact_model.h>
#include <signorini/dynamics/contact_system.h>
#include <signorini/dynamics/state.h>
#include <signorini/dynamics/step_contact.h>
#include <signorini/solid/solid_model.h>

namespace Signorini
{
  /**
   * Gives back the work sum_k (lambda_n + lambda_np)/2 (g_np - g_n), which is
   * zero in the continuous problem but not in a step in which a contact opens
   * or closes: the velocity gets s d with d = K^-1 A^T (lambda_n + lambda_np)
   * the motion that the contact forces would cause, and s the root of smaller
   * size of
   *
   *   1/2 s^2 d.M d + s d.M V = work to be returned.
   *
   * A node that lost its mass at the start of the step goes another way than
   * its mass, and its force then does work that counts alike.
   *
   * What no real s can return stays as debt for later steps, and so does what
   * would make energy: no more is returned than the step has lost, whatever the
   * sum above says of a step that is too long for an impact; and if a step in
   * which contacts open or close has made energy, it is taken. Gaps and contact
   * forces are untouched. [Cf. LaursenLove2002.]
   *
   * @param state with the ledger of the step; the work that was returned and
   *              the debt are added to it
   * @throws StepFailed if it has made energy that cannot be taken.
   */
  template <int dim>
  void
  return_contact_work(const ContactModel<dim> &contact,
                      const typename SolidModel<dim>::RedistributedMass &mass,
                      const State                          &old_state,
                      const std::vector<ContactPoint<dim>> &points,
                      const StepContact<dim>               &step_contact,
                      ContactSystem<dim>                   &system,
                      State                                &state);
} // namespace Signorini

#endif
