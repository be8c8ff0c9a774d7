#include <signorini/contact/constraint_jacobian.h>
#include <signorini/input/instantiate.h>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    // An entry of a hanging node goes to the nodes that it follows.
    void
    add_resolved(const AffineConstraints<double> &constraints,
                 const unsigned int               unknown,
                 const double                     coefficient,
                 SparseRow                       &row)
    {
      if (coefficient == 0.)
        return;
      if (!constraints.is_constrained(unknown))
        row.add(unknown, coefficient);
      else
        for (const auto &[master, factor] :
             *constraints.get_constraint_entries(unknown))
          row.add(master, coefficient * factor);
    }

    // A share of a row of the target's curvature that goes to an unknown.
    struct CurvatureShare
    {
      unsigned int unknown, row;
      double       factor;
    };

    // grad grad g over the unknowns of the nodes, each with a share of x, and
    // of the target; what belongs to a hanging node goes to its masters.
    template <int dim>
    GapCurvature
    gap_curvature(const PlacedPair<dim>  &placed,
                  const WeightedNodes    &nodes,
                  const TargetPoint<dim> &target,
                  const double            weight)
    {
      std::vector<CurvatureShare> shares;
      const auto                  add =
        [&](const unsigned int unknown, const unsigned int row, double factor) {
          if (!placed.constraints.is_constrained(unknown))
            shares.push_back({unknown, row, factor});
          else
            for (const auto &[master, share] :
                 *placed.constraints.get_constraint_entries(unknown))
              shares.push_back(
                {static_cast<unsigned int>(master), row, factor * share});
        };
      for (const auto &[node, share] : nodes)
        for (unsigned int c = 0; c < dim; ++c)
          add(placed.pair.surface.nodes[node].dofs[c], c, share);
      for (unsigned int j = 0; j < target.supporting_dofs.size(); ++j)
        add(target.supporting_dofs[j].first, dim + j, 1.);

      GapCurvature curvature;
      curvature.matrix.reinit(shares.size(), shares.size());
      for (unsigned int i = 0; i < shares.size(); ++i)
        {
          curvature.unknowns.push_back(shares[i].unknown);
          for (unsigned int j = 0; j < shares.size(); ++j)
            curvature.matrix(i, j) =
              weight * shares[i].factor * shares[j].factor *
              target.curvature(shares[i].row, shares[j].row);
        }
      return curvature;
    }

    template <int dim>
    Point<dim>
    weighted_mean(const WeightedNodes           &nodes,
                  const std::vector<Point<dim>> &positions)
    {
      Point<dim> mean;
      for (const auto &[node, weight] : nodes)
        mean += weight * positions[node];
      return mean;
    }
  } // namespace



  template <int dim>
  PlacedPair<dim>::PlacedPair(const ContactPair<dim>          &pair,
                              const Configuration             &now,
                              const Configuration             &before,
                              const AffineConstraints<double> &constraints)
    : pair(pair)
    , constraints(constraints)
    , positions(node_positions(pair.surface.nodes, now.displacement))
    , positions_before(node_positions(pair.surface.nodes, before.displacement))
    , normals(node_normals(pair.surface, positions))
    , target(pair.target->place(now, before))
  {}



  template <int dim>
  std::optional<TargetPoint<dim>>
  closest_to(const PlacedPair<dim> &placed, const WeightedNodes &nodes)
  {
    ContactorPoint<dim> point;
    point.position = weighted_mean(nodes, placed.positions);
    point.motion =
      point.position - weighted_mean(nodes, placed.positions_before);
    for (const auto &[node, weight] : nodes)
      point.normal += weight * placed.normals[node];
    if (point.normal.norm() > 0.)
      point.normal /= point.normal.norm();
    point.unknown = placed.pair.surface.nodes[nodes[0].first].dofs[0];
    point.is_node = nodes.size() == 1;
    return placed.target->closest(point);
  }



  template <int dim>
  void
  add_to_candidate(const PlacedPair<dim>  &placed,
                   const WeightedNodes    &nodes,
                   const TargetPoint<dim> &target,
                   const double            weight,
                   ContactPoint<dim>      &candidate)
  {
    if (!candidate.is_in_reach())
      candidate.gap = 0.;
    candidate.gap += weight * target.gap;
    candidate.normal += weight * target.normal;

    const Tensor<1, dim> relative_motion =
      weighted_mean(nodes, placed.positions) -
      weighted_mean(nodes, placed.positions_before) - target.motion;
    const auto add_row = [&](const Tensor<1, dim> &direction, SparseRow &row) {
      for (const auto &[node, share] : nodes)
        for (unsigned int c = 0; c < dim; ++c)
          add_resolved(placed.constraints,
                       placed.pair.surface.nodes[node].dofs[c],
                       weight * share * direction[c],
                       row);
      for (const auto &[unknown, motion] : target.supporting_dofs)
        add_resolved(placed.constraints,
                     unknown,
                     -weight * (direction * motion),
                     row);
    };
    add_row(target.normal, candidate.gap_gradient);
    for (unsigned int j = 0; j < dim - 1; ++j)
      {
        candidate.tangents[j] += weight * target.tangents[j];
        candidate.slip[j] += weight * (relative_motion * target.tangents[j]);
        add_row(target.tangents[j], candidate.slip_gradients[j]);
      }
    if (!target.curvature.empty())
      candidate.curvatures.push_back(
        gap_curvature(placed, nodes, target, weight));
  }



  template <int dim>
  std::vector<ContactPoint<dim>>
  node_to_surface_points(const PlacedPair<dim> &placed)
  {
    std::vector<ContactPoint<dim>> candidates;
    for (const unsigned int node : placed.pair.node_of_candidate)
      {
        candidates.emplace_back();
        candidates.back().area     = placed.pair.surface.areas[node];
        const WeightedNodes nodes  = {{node, 1.}};
        const auto          target = closest_to(placed, nodes);
        if (target)
          add_to_candidate(placed, nodes, *target, 1., candidates.back());
      }
    return candidates;
  }



#define INSTANTIATE(dim)                                                       \
  template struct PlacedPair<dim>;                                             \
  template std::optional<TargetPoint<dim>> closest_to(const PlacedPair<dim> &, \
                                                      const WeightedNodes &);  \
  template void add_to_candidate(const PlacedPair<dim> &,                      \
                                 const WeightedNodes &,                        \
                                 const TargetPoint<dim> &,                     \
                                 const double,                                 \
                                 ContactPoint<dim> &);                         \
  template std::vector<ContactPoint<dim>> node_to_surface_points(              \
    const PlacedPair<dim> &);
  SIGNORINI_FOR_EACH_DIMENSION(INSTANTIATE)
#undef INSTANTIATE
} // namespace Signorini
