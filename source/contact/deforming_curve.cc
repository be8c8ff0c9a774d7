#include <signorini/contact/deforming_curve.h>
#include <signorini/curves/corner_normals.h>
#include <signorini/curves/curve_crossing.h>
#include <signorini/curves/curve_search.h>
#include <signorini/curves/gap_derivatives.h>

#include <map>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    // The normal of the boundary beyond the end of a chain, whose last node is
    // at `from`, walking on in the direction of the chain (or back, at its
    // start).
    Tensor<1, 2>
    normal_beyond(const Point<2>    &from,
                  const Point<2>    &beyond,
                  const unsigned int which)
    {
      Tensor<1, 2> tangent = which == 1 ? beyond - from : from - beyond;
      tangent /= tangent.norm();
      return normal_of_tangent(tangent);
    }

    CurveEnd
    curve_end(const BoundaryChain           &chain,
              const unsigned int             which,
              const std::vector<Point<2>>   &positions,
              const std::optional<Point<2>> &beyond)
    {
      CurveEnd        end;
      const ChainEnd &chain_end = chain.ends[which];
      if (chain_end.mirrored_component)
        {
          end.kind               = CurveEndKind::symmetric;
          end.mirrored_component = *chain_end.mirrored_component;
        }
      else if (beyond)
        {
          end.kind = CurveEndKind::corner;
          end.normal =
            normal_beyond(which == 0 ? positions.front() : positions.back(),
                          *beyond,
                          which);
        }
      return end;
    }

    std::array<CurveEnd, 2>
    reference_ends(const BoundaryChain &chain)
    {
      std::vector<Point<2>> positions;
      for (const auto &node : chain.nodes)
        positions.push_back(node.point);
      std::array<CurveEnd, 2> ends;
      for (unsigned int which = 0; which < 2; ++which)
        {
          std::optional<Point<2>> beyond;
          if (chain.ends[which].beyond)
            beyond = chain.ends[which].beyond->point;
          ends[which] = curve_end(chain, which, positions, beyond);
        }
      return ends;
    }

    CurveWeights
    curve_weights(const std::vector<Point<2>> &reference,
                  const BoundaryChain         &chain,
                  const unsigned int           degree,
                  const SurfaceInterpolation  &interpolation)
    {
      const auto ends = reference_ends(chain);
      switch (interpolation.kind)
        {
          case SurfaceInterpolation::Kind::facets:
            return CurveWeights::facets(reference, chain.is_closed, ends);
          case SurfaceInterpolation::Kind::trace:
            return CurveWeights::trace(reference,
                                       chain.is_closed,
                                       degree,
                                       ends);
          default:
            return CurveWeights::overhauser(reference,
                                            chain.is_closed,
                                            interpolation.knots,
                                            interpolation.feature_angle,
                                            ends);
        }
    }

    // A chain in a configuration.
    struct PlacedChain
    {
      PlacedChain(const DeformingCurve::Chain &chain,
                  const Configuration         &now,
                  const Configuration         &before)
        : chain(chain)
        , positions_before(
            node_positions(chain.nodes.nodes, before.displacement))
        , positions(node_positions(chain.nodes.nodes, now.displacement))
        , curve(chain.weights.curve(positions))
      {
        for (unsigned int n = 0; n < positions.size(); ++n)
          largest_motion = std::max(largest_motion,
                                    positions[n].distance(positions_before[n]));
        if (chain.nodes.is_closed)
          return;
        for (unsigned int which = 0; which < 2; ++which)
          if (const auto &beyond = chain.nodes.ends[which].beyond)
            curve.set_end(which,
                          curve_end(chain.nodes,
                                    which,
                                    positions,
                                    node_positions<2>({*beyond},
                                                      now.displacement)[0]));
      }

      const DeformingCurve::Chain &chain;
      const std::vector<Point<2>>  positions_before;
      const std::vector<Point<2>>  positions;
      Curve                        curve;
      double                       largest_motion = 0.; // of a node, m
    };



    class PlacedCurve : public PlacedTarget<2>
    {
    public:
      PlacedCurve(const std::vector<DeformingCurve::Chain> &chains,
                  const Configuration                      &now,
                  const Configuration                      &before,
                  const double                              reach,
                  const double                              penetration_limit)
        : reach_(reach)
        , penetration_limit_(penetration_limit)
      {
        chains_.reserve(chains.size()); // the searches keep references
        for (const auto &chain : chains)
          {
            chains_.emplace_back(chain, now, before);
            searches_.emplace_back(chains_.back().curve);
            const auto &nodes = chain.nodes.nodes;
            for (unsigned int n = 0; n < nodes.size(); ++n)
              place_of_unknown_[nodes[n].dofs[0]] = {chains_.size() - 1, n};
          }
      }

      std::optional<TargetPoint<2>>
      closest(const ContactorPoint<2> &point) const override;

      std::optional<Tensor<1, 2>>
      passed_side(const Point<2>    &start,
                  const Point<2>    &end,
                  const double       start_gap,
                  const unsigned int unknown) const override;

      std::vector<Point<2>>
      joints() const override;

    private:
      std::optional<CurveProjection>
      closest_on(const unsigned int       chain,
                 const ContactorPoint<2> &point) const;

      CurveQuery
      query(const ContactorPoint<2> &point, const unsigned int chain) const;

      static TargetPoint<2>
      target_point(const PlacedChain &chain, const CurveProjection &projection);

      // How far inside a point comes after it crossed the curve, m.
      static double
      depth_behind(const Crossing    &crossing,
                   const PlacedChain &chain,
                   const Point<2>    &start,
                   const Point<2>    &end);

      const double             reach_;
      const double             penetration_limit_;
      std::vector<PlacedChain> chains_;
      std::vector<CurveSearch> searches_;
      std::map<unsigned int, std::pair<unsigned int, unsigned int>>
        place_of_unknown_;
    };



    std::optional<TargetPoint<2>>
    PlacedCurve::closest(const ContactorPoint<2> &point) const
    {
      std::optional<CurveProjection> nearest;
      unsigned int                   nearest_chain = 0;
      for (unsigned int c = 0; c < chains_.size(); ++c)
        {
          const auto found = closest_on(c, point);
          if (found &&
              (!nearest || std::abs(found->gap) < std::abs(nearest->gap)))
            {
              nearest       = found;
              nearest_chain = c;
            }
        }
      if (!nearest)
        return {};
      return target_point(chains_[nearest_chain], *nearest);
    }



    std::optional<CurveProjection>
    PlacedCurve::closest_on(const unsigned int       chain,
                            const ContactorPoint<2> &point) const
    {
      const Curve     &curve    = chains_[chain].curve;
      const CurveQuery question = query(point, chain);
      auto found = searches_[chain].project(point.position, question);
      if (found && point.is_node && round_joint(curve, *found))
        return found;
      if (found && !found->is_vertex)
        return found;
      if (const auto beside =
            project_beyond_ends(curve, point.position, question, point.is_node))
        return beside;
      if (found)
        face_contactor(curve, point.position, point.normal, *found);
      return found;
    }



    double
    PlacedCurve::depth_behind(const Crossing    &crossing,
                              const PlacedChain &chain,
                              const Point<2>    &start,
                              const Point<2>    &end)
    {
      constexpr unsigned int n_samples = 16;
      double                 deepest   = 0.;
      for (unsigned int i = 1; i <= n_samples; ++i)
        {
          const double t =
            crossing.fraction + i * (1. - crossing.fraction) / n_samples;
          std::vector<Point<2>> positions(chain.positions_before);
          for (unsigned int n = 0; n < positions.size(); ++n)
            positions[n] += t * (chain.positions[n] - positions[n]);
          const Curve curve = chain.chain.weights.curve(positions);
          const auto  found =
            CurveSearch(curve).project(start + t * (end - start));
          if (!found || found->gap > 0.)
            break;
          deepest = std::max(deepest, -found->gap);
        }
      return deepest;
    }



    std::optional<Tensor<1, 2>>
    PlacedCurve::passed_side(const Point<2>    &start,
                             const Point<2>    &end,
                             const double       start_gap,
                             const unsigned int unknown) const
    {
      const auto own = place_of_unknown_.find(unknown);
      for (unsigned int c = 0; c < chains_.size(); ++c)
        {
          const PlacedChain &chain = chains_[c];
          if (own != place_of_unknown_.end() && own->second.first == c)
            continue;
          const double motion = start.distance(end) + chain.largest_motion;
          if (std::min(start_gap, reach_) >= motion)
            continue;
          const Curve before =
            chain.chain.weights.curve(chain.positions_before);
          const auto crossing =
            CurveCrossing(before, chain.curve).first(start, end);
          if (crossing && depth_behind(*crossing, chain, start, end) >
                            tunnelling_depth(start, motion))
            return chain.curve.normal(crossing->place);
        }
      return {};
    }



    std::vector<Point<2>>
    PlacedCurve::joints() const
    {
      std::vector<Point<2>> list;
      for (const auto &chain : chains_)
        for (unsigned int s = 0; s < chain.curve.n_segments(); ++s)
          {
            list.push_back(chain.curve.segment(s).control[0]);
            list.push_back(chain.curve.segment(s).control[3]);
          }
      return list;
    }



    CurveQuery
    PlacedCurve::query(const ContactorPoint<2> &point,
                       const unsigned int       chain) const
    {
      CurveQuery query;
      query.search_distance   = reach_;
      query.penetration_limit = penetration_limit_;
      if (point.normal.norm() > 0.)
        query.contactor_normal = point.normal;

      // In contact of a boundary with itself a node does not meet the segments
      // that it carries.
      const auto own = place_of_unknown_.find(point.unknown);
      if (own != place_of_unknown_.end() && own->second.first == chain)
        {
          const auto segments =
            chains_[chain].chain.weights.segments_of(own->second.second);
          query.is_excluded = [segments](const unsigned int segment) {
            return std::count(segments.begin(), segments.end(), segment) > 0;
          };
        }
      return query;
    }



    TargetPoint<2>
    PlacedCurve::target_point(const PlacedChain     &chain,
                              const CurveProjection &projection)
    {
      const NodalWeights weights = chain.chain.weights.at(projection.place());
      TargetPoint<2>     target;
      target.gap      = projection.gap;
      target.normal   = projection.normal;
      target.tangents = {{tangent_of_normal(projection.normal)}};
      target.motion   = projection.point - Point<2>();
      for (unsigned int j = 0; j < weights.nodes.size(); ++j)
        {
          const unsigned int n = weights.nodes[j];
          for (unsigned int c = 0; c < 2; ++c)
            {
              Tensor<1, 2> share;
              share[c] = weights.phi[j][c];
              target.motion[c] -= share[c] * chain.positions_before[n][c];
              target.supporting_dofs.emplace_back(
                chain.chain.nodes.nodes[n].dofs[c], share);
            }
        }
      if (!projection.is_vertex)
        target.curvature = differentiate_gap(projection, weights).hessian;
      return target;
    }
  } // namespace



  DeformingCurve::DeformingCurve(const Body<2>              &body,
                                 const std::string          &boundary,
                                 const DofMap               &dof_map,
                                 const SurfaceInterpolation &interpolation)
    : DeformingTarget<2>(body, boundary, interpolation)
  {
    for (auto &nodes : boundary_chains(body, boundary, dof_map))
      {
        std::vector<Point<2>> reference;
        for (const auto &node : nodes.nodes)
          reference.push_back(node.point);
        chains_.push_back({nodes,
                           curve_weights(reference,
                                         nodes,
                                         body.scalar_fe().degree,
                                         interpolation)});
      }
  }



  std::unique_ptr<PlacedTarget<2>>
  DeformingCurve::place(const Configuration &now,
                        const Configuration &before) const
  {
    return std::make_unique<PlacedCurve>(
      chains_, now, before, reach_, penetration_limit_);
  }
} // namespace Signorini
