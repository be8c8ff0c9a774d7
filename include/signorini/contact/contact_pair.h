#ifndef signorini_contact_contact_pair_h
#define signorini_contact_contact_pair_h

#include <signorini/contact/contact_law.h>
#include <signorini/contact/contact_target.h>
#include <signorini/contact/contactor_surface.h>
#include <signorini/solid/dof_map.h>

#include <memory>
#include <string>
#include <vector>

namespace Signorini
{
  /** How gaps are tied to contact forces. */
  enum class ContactConstraint
  {
    node_to_surface, // the gap of each node
    mortar           // the mean gap over the share of each node
  };

  /** A boundary of a body against a target. */
  template <int dim>
  struct ContactPairDescription
  {
    const Body<dim>                          *body;
    std::string                               boundary;
    std::unique_ptr<const ContactTarget<dim>> target;
    ContactLaw                                law = ContactLaw();
    ContactConstraint constraint = ContactConstraint::node_to_surface;
  };

  /** The same with its nodes, and which of them are candidates. */
  template <int dim>
  struct ContactPair
  {
    /**
     * Nodes that cannot move at all are no candidates. Of those, hanging ones
     * are where their neighbours are; the others are held.
     * @param dof_map tells which unknowns are solved for
     */
    ContactPair(ContactPairDescription<dim> &&description,
                const DofMap                 &dof_map);

    /**
     * What is wrong in words if a node that is held lies inside of the target;
     * empty otherwise.
     */
    std::string
    held_penetration(const Configuration &configuration) const;

    std::string                               name; // prefix in the history
    const Body<dim>                          *body;
    std::unique_ptr<const ContactTarget<dim>> target;
    ContactLaw                                law;
    ContactConstraint                         constraint;
    ContactorSurface<dim>                     surface;   // with held nodes
    ContactorSurface<dim>                     contactor; // its candidates
    std::vector<unsigned int>                 node_of_candidate;
    std::vector<unsigned int>                 candidate_of_node;
    std::vector<Node<dim>> held_nodes;    // that cannot follow a contact force
    unsigned int           first_contact; // in the count of all pairs
  };
} // namespace Signorini

#endif
