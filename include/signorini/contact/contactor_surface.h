#ifndef signorini_contact_contactor_surface_h
#define signorini_contact_contactor_surface_h

#include <signorini/solid/body.h>

#include <string>
#include <vector>

namespace Signorini
{
  /** The side of a contact pair whose nodes carry the constraints. */
  template <int dim>
  struct ContactorSurface
  {
    std::vector<Node<dim>> nodes;

    /**
     * B_k = int N_k dA: the area that belongs to each node, with the thickness
     * or the circumference. Contact pressure is contact force over B_k. Unit:
     * m^2.
     */
    std::vector<double> areas;

    /**
     * Straight or bilinear pieces between neighbouring nodes, for pictures: 2
     * or 4 (lexicographic) indices of nodes.
     */
    std::vector<std::vector<unsigned int>> faces;

    /**
     * Contact pressure at a node under a contact force (N), in Pa. A node that
     * has no area (on the axis, with quadratic elements) gets zero.
     */
    double
    pressure(const unsigned int node, const double force) const;
  };

  /** The nodes, areas and faces of a named boundary. @throws InputError. */
  template <int dim>
  ContactorSurface<dim>
  contactor_surface(const Body<dim> &body, const std::string &boundary);
} // namespace Signorini

#endif
