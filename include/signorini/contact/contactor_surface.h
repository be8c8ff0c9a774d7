#ifndef signorini_contact_contactor_surface_h
#define signorini_contact_contactor_surface_h

#include <signorini/linear_algebra/types.h>
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
     * int N_k dA: the area that belongs to each node, with the thickness or
     * the circumference. Zero on the axis, with quadratic elements. Unit: m^2.
     */
    std::vector<double> areas;

    /**
     * Straight or bilinear pieces between neighbouring nodes: 2 or 4
     * (lexicographic) indices of nodes. In 2-D the body lies on the left of a
     * piece; in 3-D its first times its second edge points out of the body.
     */
    std::vector<std::vector<unsigned int>> faces;

    /** The whole faces of the elements: (degree + 1)^(dim-1) nodes each. */
    std::vector<std::vector<unsigned int>> elements;
    unsigned int                           degree = 1;
  };

  /** The nodes, areas and faces of a named boundary. @throws InputError. */
  template <int dim>
  ContactorSurface<dim>
  contactor_surface(const Body<dim> &body, const std::string &boundary);

  /** The positions of the nodes of a surface under a displacement, m. */
  template <int dim>
  std::vector<dealii::Point<dim>>
  node_positions(const std::vector<Node<dim>> &nodes,
                 const DofVector              &displacement);

  /**
   * By how much the area that belongs to each node has grown: the size of the
   * pieces around it, around an axis with their circumference, over that
   * before the deformation. The thickness of plane bodies is left as it was.
   */
  template <int dim>
  std::vector<double>
  area_stretches(const ContactorSurface<dim>           &surface,
                 const Formulation                      formulation,
                 const std::vector<dealii::Point<dim>> &positions);

  /**
   * Unit normals at the nodes, out of the body: the sum of those of the pieces
   * around, weighted by their size.
   */
  template <int dim>
  std::vector<dealii::Tensor<1, dim>>
  node_normals(const ContactorSurface<dim>           &surface,
               const std::vector<dealii::Point<dim>> &positions);
} // namespace Signorini

#endif
