#ifndef signorini_contact_bilinear_shape_h
#define signorini_contact_bilinear_shape_h

#include <array>

namespace Signorini
{
  /** N_a of a facet with its corners in deal.II's order, 1. */
  inline std::array<double, 4>
  bilinear_shape(const double xi, const double eta)
  {
    return {
      {(1. - xi) * (1. - eta), xi * (1. - eta), (1. - xi) * eta, xi * eta}};
  }

  /** dN_a/dxi, 1. */
  inline std::array<double, 4>
  bilinear_by_xi(const double eta)
  {
    return {{eta - 1., 1. - eta, -eta, eta}};
  }

  /** dN_a/deta, 1. */
  inline std::array<double, 4>
  bilinear_by_eta(const double xi)
  {
    return {{xi - 1., -xi, 1. - xi, xi}};
  }
} // namespace Signorini

#endif
