#ifndef signorini_contact_constraint_jacobian_h
#define signorini_contact_constraint_jacobian_h

#include <signorini/contact/contact_model.h>

namespace Signorini
{
  /** A pair in two configurations: where its contactor nodes are, and were. */
  template <int dim>
  struct PlacedPair
  {
    PlacedPair(const ContactPair<dim>                  &pair,
               const Configuration                     &now,
               const Configuration                     &before,
               const dealii::AffineConstraints<double> &constraints);

    const ContactPair<dim>                  &pair;
    const dealii::AffineConstraints<double> &constraints;
    std::vector<dealii::Point<dim>>          positions; // of surface nodes
    std::vector<dealii::Point<dim>>          positions_before;
    std::vector<dealii::Tensor<1, dim>>      normals;
    std::unique_ptr<PlacedTarget<dim>>       target;
  };

  /** A point of the contactor: the nodes it lies between, and their weights. */
  using WeightedNodes = std::vector<std::pair<unsigned int, double>>;

  /**
   * Asks the target for the point closest to sum_a N_a x_a of surface nodes a.
   */
  template <int dim>
  std::optional<TargetPoint<dim>>
  closest_to(const PlacedPair<dim> &placed, const WeightedNodes &nodes);

  /**
   * Adds to a candidate `weight' times what a point of the contactor sees of
   * its target. With w = sum_a N_a dx_a - dy the relative motion, dg = n.w and
   * ds = t.w; slip so far is the relative motion of the two points over the
   * step, s = t.((x - x_n) - (y - y_n)).
   */
  template <int dim>
  void
  add_to_candidate(const PlacedPair<dim>  &placed,
                   const WeightedNodes    &nodes,
                   const TargetPoint<dim> &target,
                   const double            weight,
                   ContactPoint<dim>      &candidate);

  /** One candidate a node: its own gap. */
  template <int dim>
  std::vector<ContactPoint<dim>>
  node_to_surface_points(const PlacedPair<dim> &placed);
} // namespace Signorini

#endif
