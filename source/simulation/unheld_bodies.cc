#include <signorini/input_error.h>
#include <signorini/named_list.h>
#include <signorini/simulation/unheld_bodies.h>
#include <signorini/solid/rigid_motion.h>
#include <signorini/variational_inequality/bound_constrained_qp.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

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
          for (auto &mode : free_rigid_modes(*part.body,
                                             solid.is_given(),
                                             part.supports.sliding_nodes()))
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

    // The contacts that are asked for forces.
    struct Choice
    {
      double largest_gap; // m
      bool   with_friction;
    };

    constexpr double anywhere = std::numeric_limits<double>::infinity();

    template <int dim>
    std::vector<std::vector<double>>
    contact_powers(const ContactModel<dim>              &contact,
                   const std::vector<ContactPoint<dim>> &points,
                   const std::vector<FreeMotion>        &motions,
                   const Choice                         &choice)
    {
      std::vector<std::vector<double>> columns;
      for (const auto &pair : contact.pairs())
        for (unsigned int n = 0; n < pair.contactor.nodes.size(); ++n)
          {
            const auto &point = points[pair.first_contact + n];
            if (!point.is_in_reach() || point.gap > choice.largest_gap)
              continue;
            const auto   normal = powers(motions, point.gap_gradient);
            const double mu =
              choice.with_friction ? pair.friction.coefficient(true, 0.) : 0.;
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

    // f + W lambda for the lambda >= 0 that makes |f + W lambda|^2/2 + g lambda
    // smallest. Without gaps g it is what no contact can balance; taken as a
    // motion, it is f as far as gaps allow.
    std::vector<double>
    unbalanced(const std::vector<double>              &load,
               const std::vector<std::vector<double>> &columns,
               const std::vector<double>              &gaps)
    {
      const unsigned int  n = columns.size();
      FullMatrix<double>  gram(n, n);
      std::vector<double> right(n, 0.);
      for (unsigned int j = 0; j < n; ++j)
        {
          right[j] = -gaps[j];
          for (unsigned int i = 0; i < load.size(); ++i)
            {
              right[j] -= columns[j][i] * load[i];
              for (unsigned int k = 0; k < n; ++k)
                gram(j, k) += columns[j][i] * columns[k][i];
            }
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

    std::vector<double>
    unbalanced(const std::vector<double>              &load,
               const std::vector<std::vector<double>> &columns)
    {
      return unbalanced(load, columns, std::vector<double>(columns.size(), 0.));
    }

    // The first motion that is not in balance.
    std::optional<unsigned int>
    find_unbalanced(const std::vector<double>              &load,
                    const std::vector<std::vector<double>> &columns)
    {
      double largest = 0.;
      for (const double power : load)
        largest = std::max(largest, std::abs(power));
      const auto rest = unbalanced(load, columns);
      for (unsigned int i = 0; i < load.size(); ++i)
        if (std::abs(rest[i]) > 1e-6 * largest)
          return i;
      return {};
    }

    // Given motions press bodies on each other in ways that loads do not tell.
    template <int dim>
    bool
    is_driven(const SolidModel<dim>                              &solid,
              const std::vector<std::unique_ptr<RigidBody<dim>>> &rigid_bodies,
              const Vector<double>                               &displacement,
              const double                                        time)
    {
      const auto moves = [&](const RigidBody<dim> &body) {
        const auto start = body.placement({displacement, 0.});
        const auto end   = body.placement({displacement, time});
        return (start.translation - end.translation).norm() > 0. ||
               (start.rotation - end.rotation).norm() > 0.;
      };
      Vector<double> given(displacement), later(displacement);
      solid.apply_supports(0., given);
      solid.apply_supports(time, later);
      return later != given ||
             std::any_of(rigid_bodies.begin(),
                         rigid_bodies.end(),
                         [&](const auto &body) { return moves(*body); });
    }

    template <int dim>
    double
    size_of_contactors(const ContactModel<dim> &contact)
    {
      double size = 0.;
      for (const auto &pair : contact.pairs())
        for (const auto &node : pair.contactor.nodes)
          size =
            std::max(size, node.point.distance(pair.contactor.nodes[0].point));
      return size;
    }

    // Moves the bodies as the loads do, stiff and without friction, until the
    // contacts that are closed can balance the loads. If they have gone far
    // without, the motion that was not in balance at the beginning.
    template <int dim>
    std::optional<unsigned int>
    find_endless_motion(const ContactModel<dim>       &contact,
                        const std::vector<FreeMotion> &motions,
                        const std::vector<double>     &load,
                        const Vector<double>          &start)
    {
      constexpr unsigned int most_moves = 200; // then it is too slow to tell
      const double           size       = size_of_contactors(contact);
      const double           step       = 0.05 * size; // normals turn little
      const double           closed     = 1e-4 * size;
      const double           far        = 2. * size;

      const auto motion_of = [&](const std::vector<double> &shares) {
        Vector<double> motion(start.size());
        for (unsigned int i = 0; i < motions.size(); ++i)
          motion.add(shares[i], motions[i].mode.motion);
        return motion;
      };
      Vector<double>              way(start.size());
      std::optional<unsigned int> first;
      for (unsigned int move = 0; move < most_moves; ++move)
        {
          Vector<double> displacement(start);
          displacement += way;
          const auto points  = contact.evaluate({displacement, 0.});
          const auto columns = [&](const double largest_gap,
                                   const bool   with_friction) {
            return contact_powers(contact,
                                  points,
                                  motions,
                                  {largest_gap, with_friction});
          };
          const auto free = find_unbalanced(load, columns(closed, true));
          if (!free)
            return {};
          if (move == 0)
            first = free;

          // 1. How fast closed contacts let the loads move the bodies
          const double speed =
            motion_of(unbalanced(load, columns(closed, false))).linfty_norm();
          // 2. A step that closes gaps, but no further
          std::vector<double> pace(load), gaps;
          for (double &share : pace)
            share *= step / speed;
          for (const auto &point : points)
            if (point.is_in_reach())
              gaps.push_back(point.gap);
          way += motion_of(unbalanced(pace, columns(anywhere, false), gaps));
          if (way.linfty_norm() > far)
            return first;
        }
      return {};
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

    const Vector<double> &force =
      solid.external_force(time, Vector<double>(solid.n_dofs()));
    std::vector<double> load;
    for (const auto &motion : motions)
      load.push_back(motion.mode.motion * force);
    auto free =
      find_unbalanced(load,
                      contact_powers(contact,
                                     contact.evaluate({displacement, 0.}),
                                     motions,
                                     {anywhere, true}));
    if (!free && !is_driven(solid, rigid_bodies, displacement, time))
      free = find_endless_motion(contact, motions, load, displacement);
    if (free)
      refuse(
        motions[*free],
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
