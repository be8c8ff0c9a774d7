#ifndef signorini_contact_facet_stiffness_h
#define signorini_contact_facet_stiffness_h

#include <signorini/contact/contactor_surface.h>

#include <deal.II/lac/full_matrix.h>

#include <array>
#include <vector>

namespace Signorini
{
  /** Where a contactor point x is seen from a facet: x = y(xi, eta) + g n. */
  struct FacetPlace
  {
    unsigned int        facet;
    double              xi, eta;
    double              gap;    // g, m
    std::array<bool, 2> slides; // false: xi or eta is held at the border
  };

  /** How the contact force on a facet turns with the nodes around it. */
  struct FacetStiffness
  {
    std::vector<unsigned int>  nodes; // of the target, those of the facet first
    dealii::FullMatrix<double> matrix; // over x and the nodes, 1/m
  };

  /**
   * The facets of a surface around each of its nodes, which give the nodes
   * their normals.
   */
  std::vector<std::vector<unsigned int>>
  facets_of_nodes(const ContactorSurface<3> &surface);

  /**
   * A unit contact force acts as f_x = n on x and as f_a = -N_a n on the
   * corners y_a of the facet, with n = m/|m|, m = sum_a N_a n_a and n_a the
   * normals at the corners. With the point given by x = y(xi, eta) + s m,
   *
   *   d(xi, eta, s) = [y_xi + s m_xi, y_eta + s m_eta, m]^-1
   *                   (dx - sum_a N_a dy_a - s sum_a N_a dn_a)
   *   dm  = sum_a N_a dn_a + m_xi dxi + m_eta deta
   *   dn  = (I - n n) dm / |m|
   *   df  = (dn, -N_a dn - n dN_a)
   *   dn_a = (I - n_a n_a) dA_a / |A_a|
   *
   * where A_a is the sum of the area vectors (y_3 - y_0) x (y_2 - y_1) of the
   * facets around a node. The derivative is not symmetric, since n is not
   * normal to the facet; what comes back is (df + df^T) / 2.
   */
  FacetStiffness
  facet_stiffness(const ContactorSurface<3>                    &surface,
                  const std::vector<std::vector<unsigned int>> &facets_of_nodes,
                  const std::vector<dealii::Point<3>>          &positions,
                  const FacetPlace                             &place);
} // namespace Signorini

#endif
