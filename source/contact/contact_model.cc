#include <signorini/contact/constraint_jacobian.h>
#include <signorini/contact/contact_model.h>
#include <signorini/contact/mortar.h>
#include <signorini/input/instantiate.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <sstream>

namespace Signorini
{
  using namespace dealii;

  template <int dim>
  ContactModel<dim>::ContactModel(std::vector<PairDescription> pairs,
                                  const DofMap                &dof_map)
    : dof_map_(dof_map)
    , interface_(dof_map)
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
        pairs_.emplace_back(std::move(description), dof_map);
        ContactPair<dim> &pair = pairs_.back();
        pair.name              = name;
        pair.first_contact     = n_contacts_;
        n_contacts_ += pair.contactor.nodes.size();
        for (const auto &node : pair.contactor.nodes)
          extent_ = std::max(extent_, node.point.norm());
      }
    offsets_.resize(pairs_.size());
    number_interface();
  }



  template <int dim>
  void
  ContactModel<dim>::number_interface()
  {
    for (const auto &pair : pairs_)
      {
        // A mean of gaps also hangs on nodes that are no candidates.
        const auto &touched = pair.constraint == ContactConstraint::mortar ?
                                pair.surface.nodes :
                                pair.contactor.nodes;
        for (const auto &node : touched)
          for (const unsigned int dof : node.dofs)
            interface_.add(dof);
        for (const unsigned int unknown : pair.target->unknowns())
          interface_.add(unknown);
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
      return pair.law.friction().is_frictionless();
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
        const PlacedPair<dim> placed(pair, now, before, dof_map_.constraints());
        auto of_pair = pair.constraint == ContactConstraint::mortar ?
                         mortar_points(placed) :
                         node_to_surface_points(placed);
        if (pair.body->kinematics() == Kinematics::finite_strain)
          {
            const auto stretches = area_stretches(pair.surface,
                                                  pair.body->formulation(),
                                                  placed.positions);
            for (unsigned int n = 0; n < of_pair.size(); ++n)
              of_pair[n].area *= stretches[pair.node_of_candidate[n]];
          }
        add_offsets(pair, now.time, before.contact, of_pair);
        std::move(of_pair.begin(), of_pair.end(), std::back_inserter(points));
      }
    return points;
  }



  template <int dim>
  void
  ContactModel<dim>::set_offset(const ContactPair<dim> &pair, GapOffset offset)
  {
    offsets_[number_of(pair)] = std::move(offset);
  }



  template <int dim>
  unsigned int
  ContactModel<dim>::number_of(const ContactPair<dim> &pair) const
  {
    return &pair - pairs_.data();
  }



  template <int dim>
  void
  ContactModel<dim>::add_offsets(const ContactPair<dim>         &pair,
                                 const double                    time,
                                 const ContactState             *state,
                                 std::vector<ContactPoint<dim>> &points) const
  {
    const GapOffset &offset = offsets_[number_of(pair)];
    for (unsigned int n = 0; n < points.size(); ++n)
      {
        if (state)
          points[n].recession =
            pair.law.recession(*state, pair.first_contact + n);
        points[n].gap += offset.value(n, time) + points[n].recession;
      }
  }



  template <int dim>
  ContactState
  ContactModel<dim>::initial_state() const
  {
    ContactState state(n_contacts_);
    for (const auto &pair : pairs_)
      for (const auto &process : pair.law.processes())
        state.quantities[process->quantity().name].resize(n_contacts_);
    return state;
  }



  template <int dim>
  void
  ContactModel<dim>::begin_slip(const std::vector<ContactPoint<dim>> &points,
                                const DofVector                      &velocity,
                                ContactState &state) const
  {
    const double rounding = 1e-10 * velocity.linfty_norm();
    for (unsigned int k = 0; k < n_contacts_; ++k)
      if (state.forces.normal[k] > 0.)
        {
          double square = 0.;
          for (const SparseRow &row : points[k].slip_gradients)
            square += std::pow(row.dot(velocity), 2);
          state.slip_rates[k]  = std::sqrt(square);
          state.is_slipping[k] = state.slip_rates[k] > rounding;
        }
  }



  template <int dim>
  void
  ContactModel<dim>::advance(const double                          step_size,
                             const std::vector<ContactPoint<dim>> &points,
                             ContactState                         &state) const
  {
    for (const auto &pair : pairs_)
      for (unsigned int n = 0; n < pair.contactor.nodes.size(); ++n)
        {
          const unsigned int k = pair.first_contact + n;
          state.gaps[k]        = points[k].gap;
          state.recessions[k]  = points[k].recession;
          pair.law.advance(step_size, points[k], k, state);
        }
  }



  template <int dim>
  std::string
  ContactModel<dim>::held_penetration(const Configuration &configuration) const
  {
    for (const auto &pair : pairs_)
      {
        const std::string penetration = pair.held_penetration(configuration);
        if (!penetration.empty())
          return penetration;
      }
    return "";
  }



  template <int dim>
  std::vector<unsigned int>
  ContactModel<dim>::tunnelling_candidates(
    const Configuration       &now,
    const Configuration       &before,
    const std::vector<double> &start_gaps,
    const std::vector<bool>   &closed) const
  {
    std::vector<unsigned int> passed;
    for (const auto &pair : pairs_)
      {
        const GapOffset      &offset = offsets_[number_of(pair)];
        const PlacedPair<dim> placed(pair, now, before, dof_map_.constraints());
        std::optional<PlacedPair<dim>> placed_before;
        if (pair.constraint == ContactConstraint::mortar)
          placed_before.emplace(pair, before, before, dof_map_.constraints());
        // A node of mortar may rest inside if others around are outside.
        const auto rests_inside = [](const PlacedPair<dim> &of_pair,
                                     const unsigned int     node) {
          const auto target = closest_to(of_pair, {{node, 1.}});
          return target && target->gap <= 0.;
        };
        // A straight way cuts a curved surface, and comes out on its side.
        const auto is_on_side = [&](const unsigned int    node,
                                    const Tensor<1, dim> &normal,
                                    const double          recession) {
          constexpr double same   = 0.966; // within 15 degrees
          const auto       target = closest_to(placed, {{node, 1.}});
          return target && target->gap >= -recession &&
                 target->normal * normal > same;
        };
        for (unsigned int n = 0; n < pair.contactor.nodes.size(); ++n)
          {
            const unsigned int k    = pair.first_contact + n;
            const unsigned int node = pair.node_of_candidate[n];
            // Worn surfaces recede, but the meshes stay where they are.
            const double recession =
              before.contact ? before.contact->recessions[k] : 0.;
            const double start_gap = start_gaps[k] - recession;
            if (closed[k] || start_gap <= 0. || offset.was_inside(n))
              continue;
            const auto side =
              placed.target->passed_side(placed.positions_before[node],
                                         placed.positions[node],
                                         start_gap,
                                         pair.contactor.nodes[n].dofs[0]);
            if (side && !is_on_side(node, *side, recession) &&
                !(placed_before && (rests_inside(*placed_before, node) ||
                                    rests_inside(placed, node))))
              passed.push_back(k);
          }
      }
    return passed;
  }



  template <int dim>
  std::vector<double>
  ContactModel<dim>::recession_gains(
    const std::vector<ContactPoint<dim>> &points,
    const ContactState                   &state) const
  {
    std::vector<double> gains(n_contacts_);
    for (const auto &pair : pairs_)
      for (unsigned int n = 0; n < pair.contactor.nodes.size(); ++n)
        {
          const unsigned int k = pair.first_contact + n;
          gains[k] = pair.law.recession(state, k) - points[k].recession;
        }
    return gains;
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
  std::vector<InterfaceContact>
  ContactModel<dim>::constraints(const std::vector<ContactPoint<dim>> &points,
                                 const ContactState &at_start) const
  {
    std::vector<InterfaceContact> contacts(n_contacts_);
    for (const auto &pair : pairs_)
      for (unsigned int n = 0; n < pair.contactor.nodes.size(); ++n)
        {
          const unsigned int       k       = pair.first_contact + n;
          const ContactPoint<dim> &point   = points[k];
          InterfaceContact        &contact = contacts[k];
          contact.gap                      = point.gap;
          contact.rounding                 = rounding();
          contact.normal = interface_.row(point.gap_gradient, -1.);
          if (pair.law.friction().is_frictionless() || !point.is_in_reach())
            continue;
          for (unsigned int j = 0; j < dim - 1; ++j)
            contact.tangents.push_back(
              interface_.row(point.slip_gradients[j], 1.));
          // A node that its supports hold along the surface cannot rub.
          if (std::all_of(contact.tangents.begin(),
                          contact.tangents.end(),
                          [](const SparseRow &row) { return row.size() == 0; }))
            {
              contact.tangents.clear();
              continue;
            }
          contact.slip = point.slip;
          contact.friction_coefficient =
            pair.law.friction_coefficient(at_start, k);
          contact.largest_friction = pair.law.largest_friction(point.area);
        }
    return contacts;
  }



  template <int dim>
  void
  ContactModel<dim>::add_contact_forces(
    const std::vector<ContactPoint<dim>> &points,
    const InterfaceForces                &contact_forces,
    const double                          factor,
    DofVector                            &forces) const
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
  std::vector<StiffnessBlock>
  ContactModel<dim>::geometric_stiffness(
    const std::vector<ContactPoint<dim>> &points,
    const std::vector<double>            &normal_forces) const
  {
    std::vector<StiffnessBlock> blocks;
    for (unsigned int k = 0; k < n_contacts_; ++k)
      {
        if (normal_forces[k] == 0.)
          continue;
        for (const GapCurvature &curvature : points[k].curvatures)
          blocks.push_back(interface_.block(curvature, -normal_forces[k]));
      }
    return blocks;
  }



#define INSTANTIATE(dim) template class ContactModel<dim>;
  SIGNORINI_FOR_EACH_DIMENSION(INSTANTIATE)
#undef INSTANTIATE
} // namespace Signorini
