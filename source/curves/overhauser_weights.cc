#include <signorini/curves/curve_weights.h>
#include <signorini/curves/smooth_parts.h>

#include <cmath>
#include <map>

namespace Signorini
{
  using namespace dealii;

  /** Finds the weights of CurveWeights::overhauser(). */
  class OverhauserBuilder
  {
  public:
    OverhauserBuilder(const std::vector<Point<2>> &reference,
                      const CurveWeights::Knots    knots,
                      CurveWeights                &result)
      : reference(reference)
      , knots(knots)
      , result(result)
    {}

    void
    build(const double feature_angle)
    {
      result.is_corner_ =
        corners_of_polygon(reference, result.is_closed_, feature_angle);
      for (const auto &part :
           smooth_parts(result.is_corner_, result.is_closed_))
        if (part.is_ring)
          add_ring();
        else
          add_open_chain(part.begin, part.n_segments);
    }

  private:
    // A linear combination of nodes, for each component.
    using Combination = std::map<unsigned int, Tensor<1, 2>>;

    // What is known of a node of a chain, or of the mirror image of one.
    struct Link
    {
      Combination place;
      Point<2>    reference;
    };

    Link
    link(const unsigned int node) const
    {
      Tensor<1, 2> one;
      one[0] = one[1]          = 1.;
      const unsigned int index = node % result.n_nodes_;
      return {{{index, one}}, reference[index]};
    }

    // x_c -> 2 e_c - x_c for the mirrored component, the other one as it is.
    static Link
    mirrored(const Link &end, const Link &neighbour, const unsigned int c)
    {
      Link image = neighbour;
      for (auto &[node, weight] : image.place)
        weight[c] *= -1.;
      for (const auto &[node, weight] : end.place)
        image.place[node][c] += 2. * weight[c];
      image.reference[c] = 2. * end.reference[c] - neighbour.reference[c];
      return image;
    }

    double
    step(const Link &a, const Link &b) const
    {
      return knots == CurveWeights::Knots::uniform ?
               1. :
               std::sqrt(a.reference.distance(b.reference));
    }

    static void
    add(Combination &sum, const double factor, const Combination &term)
    {
      for (const auto &[node, weight] : term)
        sum[node] += factor * weight;
    }

    // Derivative to the knots at the middle one of three links.
    static Combination
    middle_tangent(const Link  &a,
                   const Link  &b,
                   const Link  &c,
                   const double before,
                   const double after)
    {
      const double left  = after / (before * (before + after));
      const double right = before / (after * (before + after));
      Combination  slope;
      add(slope, -left, a.place);
      add(slope, left, b.place);
      add(slope, -right, b.place);
      add(slope, right, c.place);
      return slope;
    }

    // The same parabola, at the first of three links, seen towards the second.
    static Combination
    end_tangent(const Link  &a,
                const Link  &b,
                const Link  &c,
                const double near,
                const double far)
    {
      const double first  = (2. * near + far) / (near * (near + far));
      const double second = near / (far * (near + far));
      Combination  slope;
      add(slope, -first, a.place);
      add(slope, first + second, b.place);
      add(slope, -second, c.place);
      return slope;
    }

    // p_0 = a, p_1 = a + h m_a/3, p_2 = b - h m_b/3, p_3 = b.
    void
    set_segment(const unsigned int s,
                const Link        &a,
                const Combination &slope_a,
                const Combination &slope_b,
                const Link        &b)
    {
      const double               third   = step(a, b) / 3.;
      std::array<Combination, 4> control = {
        {a.place, a.place, b.place, b.place}};
      add(control[1], third, slope_a);
      add(control[2], -third, slope_b);

      Combination all;
      for (const auto &combination : control)
        add(all, 0., combination);
      CurveWeights::Segment &segment = result.segments_[s];
      for (const auto &entry : all)
        {
          segment.nodes.push_back(entry.first);
          for (unsigned int i = 0; i < 4; ++i)
            segment.weights[i].push_back(control[i][entry.first]);
        }
    }

    // A closed chain without a corner.
    void
    add_ring()
    {
      const unsigned int n = result.n_nodes_;
      for (unsigned int s = 0; s < n; ++s)
        {
          const Link before = link(s + n - 1), a = link(s), b = link(s + 1),
                     after    = link(s + 2);
          const double middle = step(a, b);
          set_segment(s,
                      a,
                      middle_tangent(before, a, b, step(before, a), middle),
                      middle_tangent(a, b, after, middle, step(b, after)),
                      b);
        }
    }

    void
    add_open_chain(const unsigned int begin, const unsigned int count)
    {
      std::vector<Link> links;
      for (unsigned int k = 0; k <= count; ++k)
        links.push_back(link(begin + k));
      const bool at_start = !result.is_closed_ && begin == 0 &&
                            result.ends_[0].kind == CurveEndKind::symmetric;
      const bool at_end = !result.is_closed_ &&
                          begin + count == result.n_segments() &&
                          result.ends_[1].kind == CurveEndKind::symmetric;
      std::vector<double> steps;
      for (unsigned int k = 0; k < count; ++k)
        steps.push_back(step(links[k], links[k + 1]));
      // The image is as far away to the last bit, so that the tangent has a
      // component of exactly zero.
      if (at_end)
        {
          links.push_back(mirrored(links[count],
                                   links[count - 1],
                                   result.ends_[1].mirrored_component));
          steps.push_back(steps.back());
        }
      if (at_start)
        {
          links.insert(links.begin(),
                       mirrored(links[0],
                                links[1],
                                result.ends_[0].mirrored_component));
          steps.insert(steps.begin(), steps.front());
        }

      const unsigned int       offset = at_start ? 1 : 0;
      std::vector<Combination> slopes(links.size());
      for (unsigned int k = 0; k < links.size(); ++k)
        slopes[k] = slope(links, steps, k);
      for (unsigned int k = 0; k < count; ++k)
        set_segment((begin + k) % result.n_segments(),
                    links[offset + k],
                    slopes[offset + k],
                    slopes[offset + k + 1],
                    links[offset + k + 1]);
    }

    static Combination
    slope(const std::vector<Link>   &links,
          const std::vector<double> &steps,
          const unsigned int         k)
    {
      const unsigned int last = links.size() - 1;
      if (k > 0 && k < last)
        return middle_tangent(
          links[k - 1], links[k], links[k + 1], steps[k - 1], steps[k]);
      Combination slope;
      if (last == 1)
        {
          add(slope, 1. / steps[0], links[1].place);
          add(slope, -1. / steps[0], links[0].place);
        }
      else if (k == 0)
        slope = end_tangent(links[0], links[1], links[2], steps[0], steps[1]);
      else
        add(slope,
            -1.,
            end_tangent(links[last],
                        links[last - 1],
                        links[last - 2],
                        steps[last - 1],
                        steps[last - 2]));
      return slope;
    }

    const std::vector<Point<2>> &reference;
    const CurveWeights::Knots    knots;
    CurveWeights                &result;
  };



  CurveWeights
  CurveWeights::overhauser(const std::vector<Point<2>>   &reference,
                           const bool                     is_closed,
                           const Knots                    knots,
                           const double                   feature_angle,
                           const std::array<CurveEnd, 2> &ends)
  {
    CurveWeights result(reference, is_closed, ends);
    OverhauserBuilder(reference, knots, result).build(feature_angle);
    return result;
  }
} // namespace Signorini
