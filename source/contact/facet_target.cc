#include <signorini/contact/facet_stiffness.h>
#include <signorini/contact/facet_target.h>
#include <signorini/curves/moving_triangle.h>

#include <deal.II/base/bounding_box.h>
#include <deal.II/numerics/rtree.h>

#include <algorithm>
#include <cmath>

#include "bilinear_shape.h"
#include "tangents.h"

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    // A point of a facet, from where x is seen along the normal.
    struct FacetPoint
    {
      FacetPlace            place;
      std::array<double, 4> shape; // N_a, 1
      Tensor<1, 3>          normal;
      double                overshoot; // beyond the edges, in parts of a facet
    };

    // Facets overlap so far by rounding.
    constexpr double rounding_of_place = 1e-9;

    // A point beside the border of the surface, by so little in parts of a
    // facet that strain or rounding explains it, still meets it.
    constexpr double near_border = 0.05;

    // As for curves: normals less opposed than this do not face each other.
    constexpr double maximal_cosine = -0.1;

    class PlacedFacets : public PlacedTarget<3>
    {
    public:
      PlacedFacets(
        const ContactorSurface<3>                    &surface,
        const std::vector<std::vector<unsigned int>> &facets_of_nodes,
        const Configuration                          &now,
        const Configuration                          &before,
        const double                                  reach,
        const double                                  penetration_limit);

      std::optional<TargetPoint<3>>
      closest(const ContactorPoint<3> &point) const override;

      std::optional<Tensor<1, 3>>
      passed_side(const Point<3>    &start,
                  const Point<3>    &end,
                  const double       start_gap,
                  const unsigned int unknown) const override;

    private:
      // sum_a N_a v_a over the nodes of a facet.
      template <typename T>
      Tensor<1, 3>
      interpolate(const unsigned int           facet,
                  const std::array<double, 4> &shape,
                  const std::vector<T>        &values) const;

      std::optional<FacetPoint>
      project(const unsigned int facet, const Point<3> &x) const;

      bool
      is_allowed(const FacetPoint        &candidate,
                 const ContactorPoint<3> &point) const;

      bool
      carries(const unsigned int facet, const unsigned int unknown) const;

      TargetPoint<3>
      target_point(const FacetPoint &found) const;

      const ContactorSurface<3>                    &surface_;
      const std::vector<std::vector<unsigned int>> &facets_of_nodes_;
      const double                                  reach_;
      const double                                  penetration_limit_;
      const std::vector<Point<3>>                   positions_;
      const std::vector<Point<3>>                   positions_before_;
      const std::vector<Tensor<1, 3>>               normals_;

      double largest_motion_ = 0.; // of a node over the step, m

      RTree<std::pair<BoundingBox<3>, unsigned int>> tree_;
    };



    PlacedFacets::PlacedFacets(
      const ContactorSurface<3>                    &surface,
      const std::vector<std::vector<unsigned int>> &facets_of_nodes,
      const Configuration                          &now,
      const Configuration                          &before,
      const double                                  reach,
      const double                                  penetration_limit)
      : surface_(surface)
      , facets_of_nodes_(facets_of_nodes)
      , reach_(reach)
      , penetration_limit_(penetration_limit)
      , positions_(node_positions(surface.nodes, now.displacement))
      , positions_before_(node_positions(surface.nodes, before.displacement))
      , normals_(node_normals(surface, positions_))
    {
      std::vector<std::pair<BoundingBox<3>, unsigned int>> boxes;
      for (const auto &facet : surface.faces)
        {
          std::vector<Point<3>> corners;
          for (const unsigned int node : facet)
            corners.push_back(positions_[node]);
          boxes.emplace_back(BoundingBox<3>(corners), boxes.size());
        }
      tree_ = pack_rtree(boxes);
      for (unsigned int n = 0; n < positions_.size(); ++n)
        largest_motion_ =
          std::max(largest_motion_,
                   positions_[n].distance(positions_before_[n]));
    }



    template <typename T>
    Tensor<1, 3>
    PlacedFacets::interpolate(const unsigned int           facet,
                              const std::array<double, 4> &shape,
                              const std::vector<T>        &values) const
    {
      Tensor<1, 3> sum;
      for (unsigned int a = 0; a < 4; ++a)
        sum += shape[a] * Tensor<1, 3>(values[surface_.faces[facet][a]]);
      return sum;
    }



    // Newton's method for xi, eta and s in x = y + s m.
    std::optional<FacetPoint>
    PlacedFacets::project(const unsigned int facet, const Point<3> &x) const
    {
      constexpr unsigned int most_steps = 20;
      double                 xi = 0.5, eta = 0.5, s = 0.;
      for (unsigned int step = 0; step < most_steps; ++step)
        {
          const auto         shape  = bilinear_shape(xi, eta);
          const auto         by_xi  = bilinear_by_xi(eta);
          const auto         by_eta = bilinear_by_eta(xi);
          const Tensor<1, 3> m      = interpolate(facet, shape, normals_);
          const Tensor<1, 3> rest =
            x - interpolate(facet, shape, positions_) - s * m;
          const std::array<Tensor<1, 3>, 3> columns = {
            {interpolate(facet, by_xi, positions_) +
               s * interpolate(facet, by_xi, normals_),
             interpolate(facet, by_eta, positions_) +
               s * interpolate(facet, by_eta, normals_),
             m}};
          // By Cramer's rule.
          const Tensor<1, 3> cross = cross_product_3d(columns[0], columns[1]);
          const double       determinant = cross * m;
          if (!(determinant > 0.))
            return {};
          const double dxi =
            cross_product_3d(columns[1], m) * rest / determinant;
          const double deta =
            cross_product_3d(m, columns[0]) * rest / determinant;
          xi += dxi;
          eta += deta;
          s += cross * rest / determinant;
          // What is that far beside belongs to other facets.
          if (!(std::abs(xi - 0.5) < 2. && std::abs(eta - 0.5) < 2.))
            return {};
          if (std::abs(dxi) + std::abs(deta) > 1e-12)
            continue;

          FacetPoint point;
          point.overshoot    = std::max({0., -xi, xi - 1., -eta, eta - 1.});
          point.place.facet  = facet;
          point.place.xi     = std::clamp(xi, 0., 1.);
          point.place.eta    = std::clamp(eta, 0., 1.);
          point.place.slides = {{point.place.xi == xi, point.place.eta == eta}};
          point.shape        = bilinear_shape(point.place.xi, point.place.eta);
          point.normal       = interpolate(facet, point.shape, normals_);
          point.normal /= point.normal.norm();
          point.place.gap =
            (x - interpolate(facet, point.shape, positions_)) * point.normal;
          return point;
        }
      return {};
    }



    bool
    PlacedFacets::is_allowed(const FacetPoint        &candidate,
                             const ContactorPoint<3> &point) const
    {
      return candidate.overshoot <=
               (point.is_node ? near_border : rounding_of_place) &&
             candidate.place.gap <= reach_ &&
             candidate.place.gap >= -penetration_limit_ &&
             (point.normal.norm() == 0. ||
              point.normal * candidate.normal < maximal_cosine);
    }



    bool
    PlacedFacets::carries(const unsigned int facet,
                          const unsigned int unknown) const
    {
      const auto &nodes = surface_.faces[facet];
      return std::any_of(nodes.begin(), nodes.end(), [&](const auto node) {
        return surface_.nodes[node].dofs[0] == unknown;
      });
    }



    std::optional<TargetPoint<3>>
    PlacedFacets::closest(const ContactorPoint<3> &point) const
    {
      // Facets in the order of the distance of their boxes, until no box can
      // hold a nearer point. One that x is opposite to comes before one that x
      // is beside.
      std::optional<FacetPoint> best;
      const auto                is_better = [&](const FacetPoint &candidate) {
        if (!best)
          return true;
        const bool inside = candidate.overshoot <= rounding_of_place;
        const bool best_inside = best->overshoot <= rounding_of_place;
        return inside != best_inside ?
                                inside :
                                std::abs(candidate.place.gap) < std::abs(best->place.gap);
      };
      namespace bgi = boost::geometry::index;
      for (auto near = tree_.qbegin(bgi::nearest(
             point.position, static_cast<unsigned int>(tree_.size())));
           near != tree_.qend();
           ++near)
        {
          const double distance =
            boost::geometry::distance(near->first, point.position);
          if (distance > reach_ ||
              (best && best->overshoot <= rounding_of_place &&
               distance > std::abs(best->place.gap)))
            break;
          if (carries(near->second, point.unknown))
            continue;
          const auto candidate = project(near->second, point.position);
          if (candidate && is_allowed(*candidate, point) &&
              is_better(*candidate))
            best = candidate;
        }
      if (!best)
        return {};
      return target_point(*best);
    }



    // Each facet where it was, and the path as seen from it.
    std::optional<Tensor<1, 3>>
    PlacedFacets::passed_side(const Point<3>    &start,
                              const Point<3>    &end,
                              const double       start_gap,
                              const unsigned int unknown) const
    {
      if (std::min(start_gap, reach_) >= start.distance(end) + largest_motion_)
        return {};
      const double tolerance =
        tunnelling_depth(start, end.distance(start) + largest_motion_);
      for (unsigned int f = 0; f < surface_.faces.size(); ++f)
        {
          if (carries(f, unknown))
            continue;
          const auto triangle = [&](const unsigned int a,
                                    const unsigned int b,
                                    const unsigned int c) {
            const auto    &face = surface_.faces[f];
            MovingTriangle moving;
            moving.start = {{positions_before_[face[a]],
                             positions_before_[face[b]],
                             positions_before_[face[c]]}};
            moving.end   = {
                {positions_[face[a]], positions_[face[b]], positions_[face[c]]}};
            return moving;
          };
          for (const auto &moving : {triangle(0, 1, 2), triangle(1, 3, 2)})
            if (passes(start, end, moving, tolerance))
              {
                const Tensor<1, 3> normal =
                  cross_product_3d(moving.end[1] - moving.end[0],
                                   moving.end[2] - moving.end[0]);
                return normal / normal.norm();
              }
        }
      return {};
    }



    TargetPoint<3>
    PlacedFacets::target_point(const FacetPoint &found) const
    {
      TargetPoint<3> target;
      target.gap      = found.place.gap;
      target.normal   = found.normal;
      target.tangents = tangents_of(found.normal);
      target.motion =
        interpolate(found.place.facet, found.shape, positions_) -
        interpolate(found.place.facet, found.shape, positions_before_);
      auto stiffness =
        facet_stiffness(surface_, facets_of_nodes_, positions_, found.place);
      for (unsigned int i = 0; i < stiffness.nodes.size(); ++i)
        {
          const unsigned int node  = stiffness.nodes[i];
          const double       share = i < 4 ? found.shape[i] : 0.;
          for (unsigned int c = 0; c < 3; ++c)
            {
              Tensor<1, 3> motion;
              motion[c] = share;
              target.supporting_dofs.emplace_back(surface_.nodes[node].dofs[c],
                                                  motion);
            }
        }
      target.curvature = std::move(stiffness.matrix);
      return target;
    }
  } // namespace



  FacetTarget::FacetTarget(const Body<3>              &body,
                           const std::string          &boundary,
                           const SurfaceInterpolation &interpolation)
    : DeformingTarget<3>(body, boundary, interpolation)
    , facets_of_nodes_(facets_of_nodes(surface_))
  {}



  std::unique_ptr<PlacedTarget<3>>
  FacetTarget::place(const Configuration &now,
                     const Configuration &before) const
  {
    return std::make_unique<PlacedFacets>(
      surface_, facets_of_nodes_, now, before, reach_, penetration_limit_);
  }
} // namespace Signorini
