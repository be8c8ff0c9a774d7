#ifndef signorini_contact_contact_pressures_h
#define signorini_contact_contact_pressures_h

#include <signorini/contact/contact_pair.h>
#include <signorini/contact/contact_point.h>

#include <vector>

namespace Signorini
{
  /**
   * Contact pressure at each candidate of a pair, Pa: its force by its area.
   *
   * A node on the axis, with elements of degree 2 and more, has no area: there
   * the pressure is that of the polynomial in r^2 through the other nodes of
   * the element; by symmetry it has no other powers. Not less than zero.
   * @param points        of all candidates
   * @param normal_forces of all candidates, N
   */
  template <int dim>
  std::vector<double>
  contact_pressures(const ContactPair<dim>               &pair,
                    const std::vector<ContactPoint<dim>> &points,
                    const std::vector<double>            &normal_forces);
} // namespace Signorini

#endif
