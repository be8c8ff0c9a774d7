#include <signorini/dynamics/rigid_mechanism.h>
#include <signorini/dynamics/unheld_bodies.h>
#include <signorini/input/input_error.h>
#include <signorini/input/instantiate.h>
#include <signorini/input/named_list.h>
#include <signorini/solid/rigid_motion.h>

#include <algorithm>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    struct FreeMotion
    {
      std::string owner; // "Body beam"
      std::string remedy;
      RigidMode   mode;
      bool        is_in_a_pair;
    };

    template <int dim>
    std::vector<FreeMotion>
    free_motions(
      const SolidModel<dim>                              &solid,
      const ContactModel<dim>                            &contact,
      const std::vector<std::unique_ptr<RigidBody<dim>>> &rigid_bodies)
    {
      std::vector<bool> is_touched(solid.n_dofs(), false);
      for (const unsigned int dof : contact.interface_dofs())
        is_touched[dof] = true;
      std::vector<FreeMotion> motions;
      for (const auto &part : solid.parts())
        for (auto &mode : free_rigid_modes(*part.body,
                                           DofVector(solid.n_dofs()),
                                           solid.dof_map(),
                                           part.supports.sliding_nodes()))
          {
            bool touched = false;
            for (unsigned int i = 0; i < solid.n_dofs(); ++i)
              touched = touched || (is_touched[i] && mode.motion[i] != 0.);
            motions.push_back({"Body " + part.body->name(),
                               "Fix it in its section Supports",
                               mode,
                               touched});
          }
      for (const auto &body : rigid_bodies)
        for (unsigned int c = 0; c < body->unknowns().size(); ++c)
          {
            const unsigned int dof = body->first_unknown() + c;
            if (solid.dof_map().is_constrained(dof))
              continue;
            RigidMode mode;
            mode.name = c == dim ? std::string("rotation about z") :
                                   "translation along " + component_name(c);
            mode.motion.reinit(solid.n_dofs());
            mode.motion[dof] = 1.;
            motions.push_back({"Rigid body " + body->name(),
                               "Take the component out of its entry Free",
                               mode,
                               is_touched[dof]});
          }
      return motions;
    }

    [[noreturn]] void
    refuse(const FreeMotion &motion, const std::string &why)
    {
      throw InputError(
        motion.owner,
        "a static run needs it to be held, but it can still move by " +
          motion.mode.name + why + ". " + motion.remedy +
          ", or set Time / Analysis = dynamic.");
    }

    // Given motions press bodies on each other in ways that loads do not tell.
    template <int dim>
    bool
    is_driven(const SolidModel<dim>                              &solid,
              const std::vector<std::unique_ptr<RigidBody<dim>>> &rigid_bodies,
              const DofVector                                    &displacement,
              const double                                        time)
    {
      const auto moves = [&](const RigidBody<dim> &body) {
        const auto start = body.placement({displacement, 0.});
        const auto end   = body.placement({displacement, time});
        return (start.translation - end.translation).norm() > 0. ||
               (start.rotation - end.rotation).norm() > 0.;
      };
      DofVector given(displacement), later(displacement);
      solid.apply_supports(0., given);
      solid.apply_supports(time, later);
      return later != given ||
             std::any_of(rigid_bodies.begin(),
                         rigid_bodies.end(),
                         [&](const auto &body) { return moves(*body); });
    }
  } // namespace



  template <int dim>
  void
  refuse_unheld_bodies(
    const SolidModel<dim>                              &solid,
    const ContactModel<dim>                            &contact,
    const std::vector<std::unique_ptr<RigidBody<dim>>> &rigid_bodies,
    const DofVector                                    &displacement,
    const double                                        time)
  {
    const auto motions = free_motions(solid, contact, rigid_bodies);
    if (motions.empty())
      return;
    for (const auto &motion : motions)
      if (!motion.is_in_a_pair)
        refuse(motion, "");

    std::vector<DofVector> modes;
    for (const auto &motion : motions)
      modes.push_back(motion.mode.motion);
    const RigidMechanism<dim> mechanism(
      contact, modes, solid.external_force(time, DofVector(solid.n_dofs())));
    auto free = mechanism.find_unbalanced(contact.evaluate({displacement, 0.}));
    if (!free && !is_driven(solid, rigid_bodies, displacement, time))
      free = mechanism.approach({displacement, 0.}).endless;
    if (free)
      refuse(
        motions[*free],
        ", since no contact force can balance its loads at the end of the run");
  }



#define INSTANTIATE(dim)                                  \
  template void refuse_unheld_bodies(                     \
    const SolidModel<dim> &,                              \
    const ContactModel<dim> &,                            \
    const std::vector<std::unique_ptr<RigidBody<dim>>> &, \
    const DofVector &,                                    \
    const double);
  SIGNORINI_FOR_EACH_DIMENSION(INSTANTIATE)
#undef INSTANTIATE
} // namespace Signorini
