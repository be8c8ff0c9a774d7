#ifndef signorini_dynamics_unheld_bodies_h
#define signorini_dynamics_unheld_bodies_h

#include <signorini/contact/contact_model.h>
#include <signorini/contact/rigid_body.h>
#include <signorini/linear_algebra/types.h>
#include <signorini/solid/solid_model.h>

#include <memory>
#include <vector>

namespace Signorini
{
  /**
   * A static run has an answer only if whatever moves a body as a whole is in
   * balance with contact forces. With m_i the rigid motions that the supports
   * leave free, this asks for lambda >= 0 with
   *
   *   m_i . (F + sum_k lambda_k w_k) = 0   for all i,
   *
   * w_k the directions in which a contact can push: the normal where it is
   * closest now, and with friction the two edges of its cone.
   *
   * A contact that is open now may never close. Unless given motions press the
   * bodies on each other, they are therefore moved as the loads push them, as
   * if stiff and without friction, until the contacts that are closed can
   * balance the loads. A circle that is pushed along a flat goes over its edge.
   * What has gone as far as twice the size of a contactor is refused, what
   * stays near is given the benefit of the doubt.
   *
   * @param time at which the loads are taken, s
   * @throws InputError that names the body and the motion.
   */
  template <int dim>
  void
  refuse_unheld_bodies(
    const SolidModel<dim>                              &solid,
    const ContactModel<dim>                            &contact,
    const std::vector<std::unique_ptr<RigidBody<dim>>> &rigid_bodies,
    const DofVector                                    &displacement,
    const double                                        time);
} // namespace Signorini

#endif
