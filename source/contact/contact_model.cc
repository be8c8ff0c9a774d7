#include <signorini/contact/contact_model.h>
#include <signorini/contact/contact_rows.h>
#include <signorini/contact/mortar.h>

#include <algorithm>
#include <map>
#include <sstream>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    constexpr unsigned int not_on_interface = numbers::invalid_unsigned_int;

    // Splits the nodes of the surface into candidates and nodes that cannot
    // follow a contact force; of those, hanging ones are where their
    // neighbours are. Faces that lose a node are lost for pictures only.
    template <int dim>
    void
    choose_candidates(const std::vector<bool>         &is_fixed,
                      const AffineConstraints<double> &hanging_nodes,
                      ContactPair<dim>                &pair)
    {
      const ContactorSurface<dim> &surface = pair.surface;
      pair.candidate_of_node.assign(surface.nodes.size(), not_on_interface);
      for (unsigned int n = 0; n < surface.nodes.size(); ++n)
        {
          const auto &dofs = surface.nodes[n].dofs;
          if (std::all_of(dofs.begin(), dofs.end(), [&](const unsigned int i) {
                return is_fixed[i];
              }))
            {
              if (!hanging_nodes.is_constrained(dofs[0]))
                pair.held_nodes.push_back(surface.nodes[n]);
              continue;
            }
          pair.candidate_of_node[n] = pair.contactor.nodes.size();
          pair.node_of_candidate.push_back(n);
          pair.contactor.nodes.push_back(surface.nodes[n]);
          pair.contactor.areas.push_back(surface.areas[n]);
        }
      for (auto face : surface.faces)
        {
          for (auto &node : face)
            node = pair.candidate_of_node[node];
          if (std::count(face.begin(), face.end(), not_on_interface) == 0)
            pair.contactor.faces.push_back(face);
        }
    }

    // tau_max B of a candidate, N; infinite if its friction has no bound.
    template <int dim>
    double
    largest_friction(const ContactPair<dim> &pair, const unsigned int n)
    {
      const double stress = pair.friction.largest_shear_stress();
      return std::isfinite(stress) ? stress * pair.contactor.areas[n] : stress;
    }
  } // namespace



  template <int dim>
  ContactModel<dim>::ContactModel(std::vector<PairDescription>     pairs,
                                  const std::vector<bool>         &is_fixed,
                                  const AffineConstraints<double> &constraints)
    : hanging_nodes_(constraints)
    , interface_index_(is_fixed.size(), not_on_interface)
  {
    std::map<std::string, unsigned int> n_pairs_of_target;
    for (const auto &pair : pairs)
      ++n_pairs_of_target[pair.target->name()];
    for (auto &description : pairs)
      {
        const std::string target = description.target->name();
        const std::string name   = n_pairs_of_target[target] == 1 ?
                                     target :
                                     description.body->name() + "." +
                                     description.boundary + "." + target;
        add_pair(std::move(description), is_fixed);
        pairs_.back().name = name;
      }
    number_interface(is_fixed);
  }



  template <int dim>
  void
  ContactModel<dim>::add_pair(PairDescription        &&description,
                              const std::vector<bool> &is_fixed)
  {
    ContactPair<dim> pair;
    pair.body       = description.body;
    pair.target     = std::move(description.target);
    pair.friction   = description.friction;
    pair.constraint = description.constraint;
    pair.surface    = contactor_surface(*pair.body, description.boundary);
    choose_candidates(is_fixed, hanging_nodes_, pair);
    pair.first_contact = n_contacts_;
    n_contacts_ += pair.contactor.nodes.size();
    for (const auto &node : pair.contactor.nodes)
      extent_ = std::max(extent_, node.point.norm());
    pairs_.push_back(std::move(pair));
    allowances_.emplace_back();
  }



  template <int dim>
  void
  ContactModel<dim>::number_interface(const std::vector<bool> &is_fixed)
  {
    const auto number = [&](const unsigned int unknown) {
      if (!is_fixed[unknown] && interface_index_[unknown] == not_on_interface)
        {
          interface_index_[unknown] = interface_dofs_.size();
          interface_dofs_.push_back(unknown);
        }
    };
    const auto number_resolved = [&](const unsigned int unknown) {
      if (!hanging_nodes_.is_constrained(unknown))
        number(unknown);
      else
        for (const auto &[master, factor] :
             *hanging_nodes_.get_constraint_entries(unknown))
          number(master);
    };
    for (const auto &pair : pairs_)
      {
        for (const auto &node : pair.contactor.nodes)
          for (const unsigned int dof : node.dofs)
            number(dof);
        if (pair.constraint == ContactConstraint::mortar)
          for (const auto &node : pair.surface.nodes)
            for (const unsigned int dof : node.dofs)
              number_resolved(dof);
        for (const unsigned int unknown : pair.target->unknowns())
          number_resolved(unknown);
      }
  }



  template <int dim>
  template <typename Function>
  void
  ContactModel<dim>::for_each_candidate(const Function &f) const
  {
    unsigned int k = 0;
    for (const auto &pair : pairs_)
      for (const auto &node : pair.contactor.nodes)
        f(k++, node, pair);
  }



  template <int dim>
  bool
  ContactModel<dim>::is_flat() const
  {
    return std::all_of(pairs_.begin(), pairs_.end(), [](const auto &pair) {
      return pair.target->is_flat();
    });
  }



  template <int dim>
  bool
  ContactModel<dim>::is_frictionless() const
  {
    return std::all_of(pairs_.begin(), pairs_.end(), [](const auto &pair) {
      return pair.friction.is_frictionless();
    });
  }



  template <int dim>
  const ContactPair<dim> &
  ContactModel<dim>::pair_of(const unsigned int candidate) const
  {
    AssertIndexRange(candidate, n_contacts_);
    unsigned int p = pairs_.size() - 1;
    while (pairs_[p].first_contact > candidate)
      --p;
    return pairs_[p];
  }



  template <int dim>
  std::vector<ContactPoint<dim>>
  ContactModel<dim>::evaluate(const Configuration &now,
                              const Configuration &before) const
  {
    std::vector<ContactPoint<dim>> points;
    points.reserve(n_contacts_);
    for (const auto &pair : pairs_)
      {
        const PlacedPair<dim> placed(pair, now, before, hanging_nodes_);
        auto of_pair = pair.constraint == ContactConstraint::mortar ?
                         mortar_points(placed) :
                         node_to_surface_points(placed);
        add_allowance(pair, now.time, of_pair);
        std::move(of_pair.begin(), of_pair.end(), std::back_inserter(points));
      }
    return points;
  }



  template <int dim>
  void
  ContactModel<dim>::allow_overclosure(const ContactPair<dim>    &pair,
                                       const std::vector<double> &depths,
                                       const double               end_time)
  {
    AssertDimension(depths.size(), pair.contactor.nodes.size());
    allowances_[&pair - pairs_.data()] = {depths, end_time};
  }



  template <int dim>
  void
  ContactModel<dim>::add_allowance(const ContactPair<dim>         &pair,
                                   const double                    time,
                                   std::vector<ContactPoint<dim>> &points) const
  {
    const Allowance &allowance = allowances_[&pair - pairs_.data()];
    // 1 - t / infinity is one.
    const double share = 1. - time / allowance.end_time;
    if (allowance.depths.empty() || share <= 0.)
      return;
    for (unsigned int n = 0; n < points.size(); ++n)
      points[n].gap += share * allowance.depths[n];
  }



  template <int dim>
  std::string
  ContactModel<dim>::held_penetration(const Configuration &configuration) const
  {
    for (const auto &pair : pairs_)
      {
        if (pair.held_nodes.empty())
          continue;
        const auto placed = pair.target->place(configuration, configuration);
        for (const auto &node : pair.held_nodes)
          {
            const ContactorPoint<dim> point = {
              node_positions<dim>({node}, configuration.displacement)[0],
              {},
              {},
              node.dofs[0]};
            const auto   target = placed->closest(point);
            const double rounding =
              1e-10 *
              std::max(node.point.norm(),
                       node.point.distance(pair.body->nodes()[0].point));
            if (!target || target->gap >= -rounding)
              continue;
            std::ostringstream message;
            message << "at t = " << configuration.time << " s the node of body "
                    << pair.body->name() << " at (" << node.point
                    << "), which is held by Supports, lies " << -target->gap
                    << " m inside of \"" << pair.target->name()
                    << "\" and cannot make room. Change the motion of one of "
                       "them, or leave a component of the node free.";
            return message.str();
          }
      }
    return "";
  }



  template <int dim>
  std::vector<unsigned int>
  ContactModel<dim>::passed_targets(const Configuration       &now,
                                    const Configuration       &before,
                                    const std::vector<double> &start_gaps,
                                    const std::vector<bool>   &closed) const
  {
    std::vector<unsigned int> passed;
    for (const auto &pair : pairs_)
      {
        const Allowance &allowance = allowances_[&pair - pairs_.data()];
        const auto       placed    = pair.target->place(now, before);
        const auto       starts =
          node_positions(pair.contactor.nodes, before.displacement);
        const auto ends =
          node_positions(pair.contactor.nodes, now.displacement);
        for (unsigned int n = 0; n < starts.size(); ++n)
          {
            const unsigned int k = pair.first_contact + n;
            if (!closed[k] && start_gaps[k] > 0. &&
                (allowance.depths.empty() || allowance.depths[n] == 0.) &&
                placed->is_passed(starts[n],
                                  ends[n],
                                  start_gaps[k],
                                  pair.contactor.nodes[n].dofs[0]))
              passed.push_back(k);
          }
      }
    return passed;
  }



  template <int dim>
  std::string
  ContactModel<dim>::candidates_in_words(
    const std::vector<unsigned int> &candidates) const
  {
    constexpr unsigned int most = 3;
    std::ostringstream     words;
    unsigned int           n = 0;
    for_each_candidate(
      [&](const unsigned int k, const Node<dim> &node, const auto &pair) {
        if (std::count(candidates.begin(), candidates.end(), k) == 0 ||
            ++n > most)
          return;
        words << (n > 1 ? ", " : "") << pair.name << " at (" << node.point
              << ")";
      });
    return words.str() + (n > most ? ", ..." : "");
  }



  template <int dim>
  SparseRow
  ContactModel<dim>::on_interface(const SparseRow &row,
                                  const double     factor) const
  {
    SparseRow result;
    for (const auto &[unknown, coefficient] : row)
      if (interface_index_[unknown] != not_on_interface && coefficient != 0.)
        result.add(interface_index_[unknown], factor * coefficient);
    return result;
  }



  template <int dim>
  std::vector<InterfaceContact>
  ContactModel<dim>::constraints(const std::vector<ContactPoint<dim>> &points,
                                 const std::vector<double> &coefficients) const
  {
    std::vector<InterfaceContact> contacts(n_contacts_);
    for (const auto &pair : pairs_)
      for (unsigned int n = 0; n < pair.contactor.nodes.size(); ++n)
        {
          const unsigned int       k       = pair.first_contact + n;
          const ContactPoint<dim> &point   = points[k];
          InterfaceContact        &contact = contacts[k];
          contact.gap                      = point.gap;
          contact.normal = on_interface(point.gap_gradient, -1.);
          if (pair.friction.is_frictionless() || !point.is_in_reach())
            continue;
          for (unsigned int j = 0; j < dim - 1; ++j)
            contact.tangents.push_back(
              on_interface(point.slip_gradients[j], 1.));
          contact.slip                 = point.slip;
          contact.friction_coefficient = coefficients[k];
          contact.largest_friction     = largest_friction(pair, n);
        }
    return contacts;
  }



  template <int dim>
  std::vector<double>
  ContactModel<dim>::friction_bounds(
    const std::vector<double> &coefficients,
    const std::vector<double> &normal_forces) const
  {
    std::vector<double> bounds(n_contacts_);
    for (const auto &pair : pairs_)
      for (unsigned int n = 0; n < pair.contactor.nodes.size(); ++n)
        {
          const unsigned int k = pair.first_contact + n;
          bounds[k]            = std::min(coefficients[k] * normal_forces[k],
                               largest_friction(pair, n));
        }
    return bounds;
  }



  template <int dim>
  void
  ContactModel<dim>::add_contact_forces(
    const std::vector<ContactPoint<dim>> &points,
    const InterfaceForces                &contact_forces,
    const double                          factor,
    Vector<double>                       &forces) const
  {
    AssertDimension(contact_forces.normal.size(), n_contacts_);
    for (unsigned int k = 0; k < n_contacts_; ++k)
      {
        if (contact_forces.normal[k] != 0.)
          points[k].gap_gradient.add_to(forces,
                                        factor * contact_forces.normal[k]);
        for (unsigned int j = 0; j < dim - 1; ++j)
          if (contact_forces.tangential[k][j] != 0.)
            points[k].slip_gradients[j].add_to(
              forces, -factor * contact_forces.tangential[k][j]);
      }
  }



  template <int dim>
  void
  ContactModel<dim>::add_geometric_stiffness(
    const std::vector<ContactPoint<dim>> &points,
    const std::vector<double>            &normal_forces,
    FullMatrix<double>                   &stiffness) const
  {
    for (unsigned int k = 0; k < n_contacts_; ++k)
      {
        if (normal_forces[k] == 0.)
          continue;
        for (const auto &[unknowns, matrix] : points[k].curvatures)
          for (unsigned int i = 0; i < unknowns.size(); ++i)
            for (unsigned int j = 0; j < unknowns.size(); ++j)
              {
                const unsigned int row    = interface_index_[unknowns[i]];
                const unsigned int column = interface_index_[unknowns[j]];
                if (row != not_on_interface && column != not_on_interface)
                  stiffness(row, column) -= normal_forces[k] * matrix(i, j);
              }
      }
  }



  template class ContactModel<2>;
  template class ContactModel<3>;
} // namespace Signorini
