#ifndef signorini_contact_overlap_h
#define signorini_contact_overlap_h

#include <signorini/contact/contact_pair.h>
#include <signorini/solid/occupied_region.h>

#include <vector>

namespace Signorini
{
  /** A place at which the two sides of a pair lie in each other. */
  template <int dim>
  struct Overlap
  {
    dealii::Point<dim> place; // now, m
    double             depth; // m

    // What the interpolation of the two surfaces explains of it, m.
    double sagitta;

    double length; // of the elements of the contactor there, m

    // Of a rigid surface there, m; infinite if it is flat or has an edge, and
    // for a deformable one.
    double radius;

    // A node of the contactor within two elements carries a contact force.
    bool is_pressed;
  };

  /** A pair whose overlaps are looked for. */
  template <int dim>
  struct OverlapQuery
  {
    const ContactPair<dim> &pair;

    // Of the contactor's body, and of a deformable target: null if it is rigid.
    const OccupiedRegion<dim>   &body;
    const OccupiedRegion<dim>   *target_body;
    const ContactorSurface<dim> *target_surface;

    const Configuration &configuration;

    // Of all candidates, N; empty: none.
    const std::vector<double> &normal_forces;
  };

  /**
   * Where the sides of a pair lie in each other, measured without the
   * constraint: points at and between the nodes of each surface are looked for
   * in the other body, of a rigid surface those opposite to the cells of the
   * body. Left out is what is not deeper than the sagitta
   *
   *   (h_c^2 + h_t^2) (1/R_c + 1/R_t) / 8 <= min(h_c, R) / 8,
   *
   * h lengths of elements, R radii of contactor and target: nodes on curved
   * surfaces leave that much to the pieces between them.
   */
  template <int dim>
  std::vector<Overlap<dim>>
  find_overlaps(const OverlapQuery<dim> &query);
} // namespace Signorini

#endif
