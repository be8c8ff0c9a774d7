#include <signorini/curves/curve_weights.h>
#include <signorini/curves/smooth_parts.h>

#include <algorithm>

namespace Signorini
{
  using namespace dealii;

  CurveWeights::CurveWeights(const std::vector<Point<2>>   &reference,
                             const bool                     is_closed,
                             const std::array<CurveEnd, 2> &ends)
    : n_nodes_(reference.size())
    , is_closed_(is_closed)
    , ends_(ends)
  {
    check_polygon(reference, is_closed);
    const unsigned int n_segments = is_closed ? n_nodes_ : n_nodes_ - 1;
    segments_.resize(n_segments);
    is_corner_.assign(n_segments, false);
  }



  CurveWeights
  CurveWeights::facets(const std::vector<Point<2>>   &reference,
                       const bool                     is_closed,
                       const std::array<CurveEnd, 2> &ends)
  {
    CurveWeights result(reference, is_closed, ends);
    result.is_corner_.assign(result.n_segments(), true);
    for (unsigned int s = 0; s < result.n_segments(); ++s)
      {
        Segment &segment = result.segments_[s];
        segment.nodes    = {s, (s + 1) % result.n_nodes_};
        for (unsigned int i = 0; i < 4; ++i)
          for (const double weight : {1. - i / 3., i / 3.})
            {
              Tensor<1, 2> both;
              both[0] = both[1] = weight;
              segment.weights[i].push_back(both);
            }
      }
    return result;
  }



  CurveWeights
  CurveWeights::trace(const std::vector<Point<2>>   &reference,
                      const bool                     is_closed,
                      const unsigned int             degree,
                      const std::array<CurveEnd, 2> &ends)
  {
    if (degree == 1)
      return facets(reference, is_closed, ends);
    Assert(degree == 2, ExcNotImplemented());
    CurveWeights result(reference, is_closed, ends);
    result.is_trace_ = true;
    result.segments_.resize(reference.size() / 2);
    result.is_corner_.assign(result.n_segments(), true);

    // The parabola through x_0, x_1, x_2 has the control points x_0,
    // 2 x_1 - (x_0 + x_2)/2, x_2; raised to degree three:
    const std::array<std::array<double, 3>, 4> weights = {
      {{{1., 0., 0.}},
       {{0., 4. / 3., -1. / 3.}},
       {{-1. / 3., 4. / 3., 0.}},
       {{0., 0., 1.}}}};
    for (unsigned int s = 0; s < result.n_segments(); ++s)
      {
        Segment &segment = result.segments_[s];
        segment.nodes    = {2 * s, 2 * s + 1, (2 * s + 2) % result.n_nodes_};
        for (unsigned int i = 0; i < 4; ++i)
          for (const double weight : weights[i])
            {
              Tensor<1, 2> both;
              both[0] = both[1] = weight;
              segment.weights[i].push_back(both);
            }
      }
    return result;
  }



  std::vector<unsigned int>
  CurveWeights::segments_of(const unsigned int node) const
  {
    std::vector<unsigned int> result;
    // A node is felt two segments away at most.
    const unsigned int n      = n_segments();
    const unsigned int window = std::min(n, 6u);
    const unsigned int degree =
      segments_[0].nodes.size() == 3 && is_trace_ ? 2 : 1;
    for (unsigned int i = 0; i < window; ++i)
      {
        const unsigned int s     = (node / degree + n + i + n - 3) % n;
        const auto        &nodes = segments_[s].nodes;
        if (std::find(nodes.begin(), nodes.end(), node) != nodes.end())
          result.push_back(s);
      }
    std::sort(result.begin(), result.end());
    return result;
  }



  BezierSegment
  CurveWeights::segment(const std::vector<Point<2>> &positions,
                        const unsigned int           s) const
  {
    BezierSegment  result;
    const Segment &segment = segments_[s];
    for (unsigned int i = 0; i < 4; ++i)
      for (unsigned int j = 0; j < segment.nodes.size(); ++j)
        for (unsigned int c = 0; c < 2; ++c)
          result.control[i][c] +=
            segment.weights[i][j][c] * positions[segment.nodes[j]][c];
    return result;
  }



  Curve
  CurveWeights::curve(const std::vector<Point<2>> &positions) const
  {
    AssertDimension(positions.size(), n_nodes_);
    std::vector<BezierSegment> segments;
    segments.reserve(n_segments());
    for (unsigned int s = 0; s < n_segments(); ++s)
      segments.push_back(segment(positions, s));
    return Curve(std::move(segments), is_corner_, is_closed_, ends_);
  }



  void
  CurveWeights::update(const std::vector<Point<2>> &positions,
                       Curve                       &curve) const
  {
    AssertDimension(positions.size(), n_nodes_);
    AssertDimension(curve.n_segments(), n_segments());
    for (unsigned int s = 0; s < n_segments(); ++s)
      curve.set_segment(s, segment(positions, s));
  }



  void
  CurveWeights::update(const std::vector<Point<2>>     &positions,
                       const std::vector<unsigned int> &segments,
                       Curve                           &curve) const
  {
    AssertDimension(positions.size(), n_nodes_);
    for (const unsigned int s : segments)
      curve.set_segment(s, segment(positions, s));
  }



  NodalWeights
  CurveWeights::at(const CurveParameter &place) const
  {
    const Segment &segment     = segments_[place.segment];
    const auto     values      = bernstein(place.xi);
    const auto     derivatives = bernstein_derivative(place.xi);
    NodalWeights   result;
    result.nodes = segment.nodes;
    result.phi.resize(segment.nodes.size());
    result.dphi.resize(segment.nodes.size());
    for (unsigned int i = 0; i < 4; ++i)
      for (unsigned int j = 0; j < segment.nodes.size(); ++j)
        {
          result.phi[j] += values[i] * segment.weights[i][j];
          result.dphi[j] += derivatives[i] * segment.weights[i][j];
        }
    return result;
  }
} // namespace Signorini
