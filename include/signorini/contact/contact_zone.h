#ifndef signorini_contact_contact_zone_h
#define signorini_contact_contact_zone_h

#include <signorini/contact/contact_pair.h>
#include <signorini/linear_algebra/types.h>

#include <vector>

namespace Signorini
{
  /** Where the two surfaces of a pair press on each other. */
  template <int dim>
  struct ContactZone
  {
    std::vector<dealii::Point<dim>> points; // nodes with contact force, m

    /**
     * Of the surface in contact: its length in 2-D, the side of a square of its
     * area in 3-D. Each face counts by the share of its nodes that have a
     * contact force. Unit: m.
     */
    double width = 0.;
  };

  /**
   * @param normal_forces of the candidates of all pairs, N
   * @param displacement  of all unknowns, m
   */
  template <int dim>
  ContactZone<dim>
  contact_zone(const ContactPair<dim>    &pair,
               const std::vector<double> &normal_forces,
               const DofVector           &displacement);

  /** An open node near which the surfaces may touch. */
  template <int dim>
  struct NearMiss
  {
    dealii::Point<dim> point; // m
    double             gap;   // m

    /**
     * Between two nodes at a distance h a body of the radius R comes nearer
     * than at the nodes by at most h^2/8R, a quarter of what the gap grows from
     * the nearer node to the next. True if the gap is smaller than this.
     */
    bool may_touch_beside;
  };

  /**
   * All open nodes with a target in reach.
   * @param normal_forces of the candidates of all pairs, N
   * @param gaps          of the same, m
   */
  template <int dim>
  std::vector<NearMiss<dim>>
  near_misses(const ContactPair<dim>    &pair,
              const std::vector<double> &normal_forces,
              const std::vector<double> &gaps,
              const DofVector           &displacement);
} // namespace Signorini

#endif
