#include <signorini/curves/curve_search.h>

#include <algorithm>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    std::vector<BoundingBox<2>>
    boxes_of(const Curve &curve)
    {
      std::vector<BoundingBox<2>> boxes;
      boxes.reserve(curve.n_segments());
      for (unsigned int s = 0; s < curve.n_segments(); ++s)
        boxes.push_back(curve.segment(s).box());
      return boxes;
    }

    // Distance to the control points' box: no point of the segment is nearer.
    double
    distance_to_box(const BezierSegment &segment, const Point<2> &x)
    {
      Tensor<1, 2> outside;
      for (unsigned int d = 0; d < 2; ++d)
        {
          const auto &p     = segment.control;
          const auto  range = std::minmax({p[0][d], p[1][d], p[2][d], p[3][d]});
          outside[d] = std::max({0., range.first - x[d], x[d] - range.second});
        }
      return outside.norm();
    }

    // All but the rule that needs the other candidates.
    bool
    is_allowed(const CurveProjection &projection,
               const double           distance,
               const CurveQuery      &query)
    {
      return distance <= query.search_distance &&
             projection.gap >= -query.penetration_limit &&
             (!query.contactor_normal ||
              *query.contactor_normal * projection.normal <
                query.maximal_cosine);
    }
  } // namespace



  CurveSearch::CurveSearch(const Curve &curve)
    : curve_(&curve)
    , tree_(boxes_of(curve))
  {}



  void
  CurveSearch::update()
  {
    tree_ = SegmentTree(boxes_of(*curve_));
  }



  void
  CurveSearch::add_candidates(const unsigned int      segment,
                              const Point<2>         &x,
                              const CurveQuery       &query,
                              std::vector<Candidate> &candidates) const
  {
    if (query.is_excluded && query.is_excluded(segment))
      return;
    std::vector<CurveProjection> places;
    find_nearest_places(*curve_, segment, x, places);
    for (const auto &place : places)
      if (place.xi < 1. || !query.is_excluded || !curve_->has_next(segment) ||
          !query.is_excluded(curve_->next(segment)))
        candidates.push_back({place, x.distance(place.point)});
  }



  // Every local minimum within the search distance; if only the nearest is
  // asked for, those that are no farther than the first that is allowed.
  std::vector<CurveSearch::Candidate>
  CurveSearch::candidates(const Point<2>   &x,
                          const CurveQuery &query,
                          const bool        only_nearest) const
  {
    double                 radius = query.search_distance;
    std::vector<Candidate> result;
    const auto             visit = [&](const unsigned int segment) {
      const unsigned int begin = result.size();
      add_candidates(segment, x, query, result);
      if (only_nearest)
        for (unsigned int i = begin; i < result.size(); ++i)
          if (is_allowed(result[i].projection, result[i].distance, query))
            radius = std::min(radius, result[i].distance);
    };

    // 1. A first guess bounds the distance.
    std::vector<unsigned int> first, near;
    if (only_nearest)
      {
        tree_.find_nearest(x, 2, first);
        for (const unsigned int segment : first)
          visit(segment);
      }

    // 2. No box that this distance reaches is forgotten.
    const double       reach  = std::min(radius * (1. + 1e-12) + 1e-300,
                                  0.1 * std::numeric_limits<double>::max());
    const Tensor<1, 2> around = Point<2>(reach, reach);
    tree_.find(x - around, x + around, near);
    std::vector<std::pair<double, unsigned int>> ordered;
    for (const unsigned int segment : near)
      if (std::find(first.begin(), first.end(), segment) == first.end())
        ordered.emplace_back(distance_to_box(curve_->segment(segment), x),
                             segment);
    std::sort(ordered.begin(), ordered.end());
    for (const auto &[distance, segment] : ordered)
      if (distance <= radius * (1. + 1e-12))
        visit(segment);

    std::sort(result.begin(),
              result.end(),
              [](const Candidate &a, const Candidate &b) {
                return a.distance < b.distance;
              });
    return result;
  }



  std::optional<CurveProjection>
  CurveSearch::project(const Point<2> &x, const CurveQuery &query) const
  {
    for (const bool only_nearest : {true, false})
      {
        const auto found   = candidates(x, query, only_nearest);
        bool       is_void = false;
        for (const Candidate &candidate : found)
          {
            const CurveProjection &projection = candidate.projection;
            if (!is_allowed(projection, candidate.distance, query))
              continue;
            // The bound of the search came from a point that is none.
            if (projection.gap < 0. && found[0].projection.gap > 0.)
              {
                is_void = true;
                if (only_nearest)
                  break;
                continue;
              }
            return projection;
          }
        if (!is_void)
          break;
      }
    return {};
  }
} // namespace Signorini
