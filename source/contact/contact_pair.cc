#include <signorini/contact/contact_pair.h>
#include <signorini/input/instantiate.h>

#include <algorithm>
#include <sstream>

namespace Signorini
{
  using namespace dealii;

  template <int dim>
  ContactPair<dim>::ContactPair(ContactPairDescription<dim> &&description,
                                const DofMap                 &dof_map)
    : body(description.body)
    , target(std::move(description.target))
    , law(std::move(description.law))
    , constraint(description.constraint)
    , surface(contactor_surface(*body, description.boundary))
    , candidate_of_node(surface.nodes.size(), numbers::invalid_unsigned_int)
    , first_contact(0)
  {
    for (unsigned int n = 0; n < surface.nodes.size(); ++n)
      {
        const auto &dofs = surface.nodes[n].dofs;
        if (std::all_of(dofs.begin(), dofs.end(), [&](const unsigned int i) {
              return dof_map.is_constrained(i);
            }))
          {
            if (!dof_map.constraints().is_constrained(dofs[0]))
              held_nodes.push_back(surface.nodes[n]);
            continue;
          }
        candidate_of_node[n] = contactor.nodes.size();
        node_of_candidate.push_back(n);
        contactor.nodes.push_back(surface.nodes[n]);
      }
    // Faces that lose a node are lost for pictures only.
    for (auto face : surface.faces)
      {
        for (auto &node : face)
          node = candidate_of_node[node];
        if (std::count(face.begin(),
                       face.end(),
                       numbers::invalid_unsigned_int) == 0)
          contactor.faces.push_back(face);
      }
  }



  template <int dim>
  std::string
  ContactPair<dim>::held_penetration(const Configuration &configuration) const
  {
    if (held_nodes.empty())
      return "";
    const auto placed = target->place(configuration, configuration);
    for (const auto &node : held_nodes)
      {
        const ContactorPoint<dim> point = {
          node_positions<dim>({node}, configuration.displacement)[0],
          {},
          {},
          node.dofs[0]};
        const auto   found = placed->closest(point);
        const double rounding =
          1e-10 * std::max(node.point.norm(),
                           node.point.distance(body->nodes()[0].point));
        if (!found || found->gap >= -rounding)
          continue;
        std::ostringstream message;
        message << "at t = " << configuration.time << " s the node of body "
                << body->name() << " at (" << node.point
                << "), which is held by Supports, lies " << -found->gap
                << " m inside of \"" << target->name()
                << "\" and cannot make room. Change the motion of one of "
                   "them, or leave a component of the node free.";
        return message.str();
      }
    return "";
  }



#define INSTANTIATE(dim) template struct ContactPair<dim>;
  SIGNORINI_FOR_EACH_DIMENSION(INSTANTIATE)
#undef INSTANTIATE
} // namespace Signorini
