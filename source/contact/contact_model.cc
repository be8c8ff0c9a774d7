#include <signorini/contact/contact_model.h>

#include <map>
#include <sstream>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    constexpr unsigned int not_on_interface = static_cast<unsigned int>(-1);

    // Takes out the nodes that cannot follow a contact force, and returns those
    // of them that are held; hanging ones are where their neighbours are. Faces
    // that lose a node are lost for pictures only.
    template <int dim>
    std::vector<Node<dim>>
    remove_fixed_nodes(ContactorSurface<dim>   &surface,
                       const std::vector<bool> &is_fixed,
                       const std::vector<bool> &is_hanging)
    {
      ContactorSurface<dim>     kept;
      std::vector<Node<dim>>    held;
      std::vector<unsigned int> new_index(surface.nodes.size(),
                                          not_on_interface);
      for (unsigned int n = 0; n < surface.nodes.size(); ++n)
        {
          const auto &dofs = surface.nodes[n].dofs;
          if (std::all_of(dofs.begin(), dofs.end(), [&](const unsigned int i) {
                return is_fixed[i];
              }))
            {
              if (!is_hanging[dofs[0]])
                held.push_back(surface.nodes[n]);
              continue;
            }
          new_index[n] = kept.nodes.size();
          kept.nodes.push_back(surface.nodes[n]);
          kept.areas.push_back(surface.areas[n]);
        }
      for (auto face : surface.faces)
        {
          for (auto &node : face)
            node = new_index[node];
          if (std::count(face.begin(), face.end(), not_on_interface) == 0)
            kept.faces.push_back(face);
        }
      surface = std::move(kept);
      return held;
    }

    template <int dim>
    Point<dim>
    position_of(const Node<dim> &node, const Vector<double> &displacement)
    {
      Point<dim> position = node.point;
      for (unsigned int c = 0; c < dim; ++c)
        position[c] += displacement[node.dofs[c]];
      return position;
    }
  } // namespace



  template <int dim>
  ContactModel<dim>::ContactModel(const std::vector<PairNames> &pairs,
                                  const std::vector<bool>      &is_fixed,
                                  const std::vector<bool>      &is_hanging)
    : interface_index_(is_fixed.size(), not_on_interface)
  {
    std::map<std::string, unsigned int> n_pairs_of_target;
    for (const auto &pair : pairs)
      ++n_pairs_of_target[pair.target->name()];

    for (const auto &[body, boundary, target] : pairs)
      {
        ContactPair<dim> pair;
        pair.body          = body;
        pair.target        = target;
        pair.contactor     = contactor_surface(*body, boundary);
        pair.name          = n_pairs_of_target[target->name()] == 1 ?
                               target->name() :
                               body->name() + "." + boundary + "." + target->name();
        pair.first_contact = n_contacts_;
        pair.held_nodes =
          remove_fixed_nodes(pair.contactor, is_fixed, is_hanging);
        n_contacts_ += pair.contactor.nodes.size();
        pairs_.push_back(std::move(pair));
      }

    for_each_candidate(
      [&](const unsigned int, const Node<dim> &node, const auto &) {
        for (const unsigned int dof : node.dofs)
          if (!is_fixed[dof] && interface_index_[dof] == not_on_interface)
            {
              interface_index_[dof] = interface_dofs_.size();
              interface_dofs_.push_back(dof);
            }
      });
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
  std::vector<SurfacePoint<dim>>
  ContactModel<dim>::evaluate(const Vector<double> &displacement,
                              const double          time) const
  {
    std::vector<SurfacePoint<dim>> points;
    points.reserve(n_contacts_);
    for (const auto &pair : pairs_)
      {
        const Tensor<1, dim> translation = pair.target->translation(time);
        for (const auto &node : pair.contactor.nodes)
          points.push_back(
            pair.target->closest(position_of(node, displacement), translation));
      }
    return points;
  }



  template <int dim>
  std::string
  ContactModel<dim>::held_penetration(const Vector<double> &displacement,
                                      const double          time) const
  {
    for (const auto &pair : pairs_)
      {
        const Tensor<1, dim> translation = pair.target->translation(time);
        for (const auto &node : pair.held_nodes)
          {
            const Point<dim> position = position_of(node, displacement);
            const double gap = pair.target->closest(position, translation).gap;
            const double rounding =
              1e-10 *
              std::max(node.point.norm(),
                       node.point.distance(pair.body->nodes()[0].point));
            if (gap >= -rounding)
              continue;
            std::ostringstream message;
            message << "at t = " << time << " s the node of body "
                    << pair.body->name() << " at (" << node.point
                    << "), which is held by Supports, lies " << -gap
                    << " m inside of the rigid body \"" << pair.target->name()
                    << "\" and cannot make room. Change the motion of one of "
                       "them, or leave a component of the node free.";
            return message.str();
          }
      }
    return "";
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
  ContactModel<dim>::constraints(
    const std::vector<SurfacePoint<dim>> &points) const
  {
    std::vector<InterfaceContact> contacts(n_contacts_);
    for_each_candidate(
      [&](const unsigned int k, const Node<dim> &node, const auto &) {
        contacts[k].gap = points[k].gap;
        for (unsigned int c = 0; c < dim; ++c)
          {
            const unsigned int index = interface_index_[node.dofs[c]];
            if (index != not_on_interface && points[k].normal[c] != 0.)
              contacts[k].normal.add(index, -points[k].normal[c]);
          }
      });
    return contacts;
  }



  template <int dim>
  void
  ContactModel<dim>::add_contact_forces(
    const std::vector<SurfacePoint<dim>> &points,
    const std::vector<double>            &normal_forces,
    const double                          factor,
    Vector<double>                       &forces) const
  {
    AssertDimension(normal_forces.size(), n_contacts_);
    for_each_candidate(
      [&](const unsigned int k, const Node<dim> &node, const auto &) {
        if (normal_forces[k] != 0.)
          for (unsigned int c = 0; c < dim; ++c)
            forces[node.dofs[c]] +=
              factor * normal_forces[k] * points[k].normal[c];
      });
  }



  template <int dim>
  void
  ContactModel<dim>::add_geometric_stiffness(
    const std::vector<SurfacePoint<dim>> &points,
    const std::vector<double>            &normal_forces,
    FullMatrix<double>                   &stiffness) const
  {
    for_each_candidate(
      [&](const unsigned int k, const Node<dim> &node, const auto &) {
        if (normal_forces[k] == 0.)
          return;
        for (unsigned int c = 0; c < dim; ++c)
          for (unsigned int d = 0; d < dim; ++d)
            {
              const unsigned int i = interface_index_[node.dofs[c]];
              const unsigned int j = interface_index_[node.dofs[d]];
              if (i != not_on_interface && j != not_on_interface)
                stiffness(i, j) -= normal_forces[k] * points[k].curvature[c][d];
            }
      });
  }



  template class ContactModel<2>;
  template class ContactModel<3>;
} // namespace Signorini
