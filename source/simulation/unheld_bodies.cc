#include <signorini/input_error.h>
#include <signorini/named_list.h>
#include <signorini/simulation/unheld_bodies.h>
#include <signorini/solid/rigid_motion.h>
#include <signorini/variational_inequality/bound_constrained_qp.h>

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
        {
          bool touched = false;
          for (const auto &node : part.body->nodes())
            for (const unsigned int dof : node.dofs)
              touched = touched || is_touched[dof];
          for (auto &mode : free_rigid_modes(*part.body, solid.is_fixed()))
            motions.push_back({"Body " + part.body->name(),
                               "Fix it in its section Supports",
                               mode,
                               touched});
        }
      for (const auto &body : rigid_bodies)
        for (unsigned int c = 0; c < body->unknowns().size(); ++c)
          {
            const unsigned int dof = body->first_unknown() + c;
            if (solid.is_fixed()[dof])
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
      throw InputError(motion.owner +
                       ": a static run needs it to be held, but it can still "
                       "move by " +
                       motion.mode.name + why + ". " + motion.remedy +
                       ", or set Time / Analysis = dynamic.");
    }

    // m_i . w for every free motion.
    std::vector<double>
    powers(const std::vector<FreeMotion> &motions, const SparseRow &row)
    {
      std::vector<double> result;
      for (const auto &motion : motions)
        result.push_back(row.dot(motion.mode.motion));
      return result;
    }

    template <int dim>
    std::vector<std::vector<double>>
    contact_powers(const ContactModel<dim>              &contact,
                   const std::vector<ContactPoint<dim>> &points,
                   const std::vector<FreeMotion>        &motions)
    {
      std::vector<std::vector<double>> columns;
      for (const auto &pair : contact.pairs())
        for (unsigned int n = 0; n < pair.contactor.nodes.size(); ++n)
          {
            const auto &point = points[pair.first_contact + n];
            if (!point.is_in_reach())
              continue;
            const auto   normal = powers(motions, point.gap_gradient);
            const double mu     = pair.friction.coefficient(true, 0.);
            if (mu == 0.)
              columns.push_back(normal);
            else
              for (const auto &row : point.slip_gradients)
                for (const double sign : {-1., 1.})
                  {
                    const auto tangential = powers(motions, row);
                    columns.push_back(normal);
                    for (unsigned int i = 0; i < motions.size(); ++i)
                      columns.back()[i] += sign * mu * tangential[i];
                  }
          }
      return columns;
    }

    // f + W lambda for the lambda >= 0 that makes it smallest.
    std::vector<double>
    unbalanced(const std::vector<double>              &load,
               const std::vector<std::vector<double>> &columns)
    {
      const unsigned int  n = columns.size();
      FullMatrix<double>  gram(n, n);
      std::vector<double> right(n, 0.);
      for (unsigned int j = 0; j < n; ++j)
        for (unsigned int i = 0; i < load.size(); ++i)
          {
            right[j] -= columns[j][i] * load[i];
            for (unsigned int k = 0; k < n; ++k)
              gram(j, k) += columns[j][i] * columns[k][i];
          }
      std::vector<double> rest(load);
      if (n == 0)
        return rest;
      const auto solution =
        solve_bound_constrained_qp(gram, right, std::vector<double>(n, 0.));
      for (unsigned int j = 0; j < n; ++j)
        for (unsigned int i = 0; i < load.size(); ++i)
          rest[i] += solution.x[j] * columns[j][i];
      return rest;
    }
  } // namespace



  template <int dim>
  void
  refuse_unheld_bodies(
    const SolidModel<dim>                              &solid,
    const ContactModel<dim>                            &contact,
    const std::vector<std::unique_ptr<RigidBody<dim>>> &rigid_bodies,
    const Vector<double>                               &displacement,
    const double                                        time)
  {
    const auto motions = free_motions(solid, contact, rigid_bodies);
    if (motions.empty())
      return;
    for (const auto &motion : motions)
      if (!motion.is_in_a_pair)
        refuse(motion, "");

    const Vector<double> &force = solid.external_force(time);
    std::vector<double>   load;
    double                largest = 0.;
    for (const auto &motion : motions)
      {
        load.push_back(motion.mode.motion * force);
        largest = std::max(largest, std::abs(load.back()));
      }
    const auto points = contact.evaluate({displacement, 0.});
    const auto rest =
      unbalanced(load, contact_powers(contact, points, motions));
    for (unsigned int i = 0; i < motions.size(); ++i)
      if (std::abs(rest[i]) > 1e-6 * largest)
        refuse(
          motions[i],
          ", since no contact force can balance its loads at the end of the run");
  }



  template void
  refuse_unheld_bodies(const SolidModel<2> &,
                       const ContactModel<2> &,
                       const std::vector<std::unique_ptr<RigidBody<2>>> &,
                       const Vector<double> &,
                       const double);
  template void
  refuse_unheld_bodies(const SolidModel<3> &,
                       const ContactModel<3> &,
                       const std::vector<std::unique_ptr<RigidBody<3>>> &,
                       const Vector<double> &,
                       const double);
} // namespace Signorini
