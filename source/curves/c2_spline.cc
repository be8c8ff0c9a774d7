#include <signorini/curves/c2_spline.h>
#include <signorini/curves/smooth_parts.h>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    using Slopes = std::vector<Tensor<1, 2>>;
    using Ends   = std::array<std::optional<Tensor<1, 2>>, 2>;

    /** below_i m_(i-1) + diagonal_i m_i + above_i m_(i+1) = right_i. */
    struct Tridiagonal
    {
      std::vector<double> below, diagonal, above;
      Slopes              right;

      explicit Tridiagonal(const unsigned int n)
        : below(n)
        , diagonal(n)
        , above(n)
        , right(n)
      {}

      // Gauss without pivots: the matrix is diagonally dominant.
      Slopes
      solve() const
      {
        const unsigned int  n = diagonal.size();
        std::vector<double> pivot(diagonal);
        Slopes              m(right);
        for (unsigned int i = 1; i < n; ++i)
          {
            const double factor = below[i] / pivot[i - 1];
            pivot[i] -= factor * above[i - 1];
            m[i] -= factor * m[i - 1];
          }
        m[n - 1] /= pivot[n - 1];
        for (unsigned int i = n - 1; i-- > 0;)
          m[i] = (m[i] - above[i] * m[i + 1]) / pivot[i];
        return m;
      }
    };

    // The points of one part and the steps between them.
    struct Part
    {
      std::vector<Point<2>> points;
      std::vector<double>   steps;

      Tensor<1, 2>
      chord(const unsigned int i) const
      {
        return (points[i + 1] - points[i]) / steps[i];
      }

      void
      set_row(Tridiagonal       &system,
              const unsigned int row,
              const unsigned int before,
              const unsigned int after) const
      {
        system.below[row]    = steps[after];
        system.diagonal[row] = 2. * (steps[before] + steps[after]);
        system.above[row]    = steps[before];
        system.right[row] =
          3. * (steps[after] * chord(before) + steps[before] * chord(after));
      }
    };

    Slopes
    open_slopes(const Part &part, const Ends &tangents)
    {
      const unsigned int n = part.points.size();
      Tridiagonal        system(n);
      for (unsigned int i = 1; i + 1 < n; ++i)
        part.set_row(system, i, i - 1, i);
      for (const unsigned int end : {0, 1})
        {
          const unsigned int row        = end == 0 ? 0 : n - 1;
          const bool         is_clamped = tangents[end].has_value();
          system.diagonal[row]          = is_clamped ? 1. : 2.;
          (end == 0 ? system.above : system.below)[row] = is_clamped ? 0. : 1.;
          system.right[row] =
            is_clamped ? *tangents[end] : 3. * part.chord(end == 0 ? 0 : n - 2);
        }
      return system.solve();
    }

    // Periodic: the two entries outside of the band are a matrix of rank one,
    // taken into account by the formula of Sherman and Morrison.
    Slopes
    ring_slopes(const Part &part)
    {
      const unsigned int n = part.steps.size();
      Tridiagonal        system(n);
      for (unsigned int i = 0; i < n; ++i)
        part.set_row(system, i, (i + n - 1) % n, i);
      const double corner_above = system.below[0];     // row 0, column n-1
      const double corner_below = system.above[n - 1]; // row n-1, column 0
      const double gamma        = -system.diagonal[0];
      system.diagonal[0] -= gamma;
      system.diagonal[n - 1] -= corner_above * corner_below / gamma;
      const Slopes m = system.solve();
      for (auto &value : system.right)
        value = 0.;
      system.right[0][0]     = gamma;
      system.right[n - 1][0] = corner_below;
      const Slopes q         = system.solve();
      const double last      = corner_above / gamma;
      const auto   factor =
        (m[0] + last * m[n - 1]) / (1. + q[0][0] + last * q[n - 1][0]);
      Slopes result(n + 1);
      for (unsigned int i = 0; i < n; ++i)
        result[i] = m[i] - q[i][0] * factor;
      result[n] = result[0];
      return result;
    }
  } // namespace



  Curve
  c2_spline(const std::vector<Point<2>>   &points,
            const bool                     is_closed,
            const double                   feature_angle,
            const Ends                    &tangents,
            const std::array<CurveEnd, 2> &ends)
  {
    check_polygon(points, is_closed);
    const auto is_corner = corners_of_polygon(points, is_closed, feature_angle);
    std::vector<BezierSegment> segments(is_corner.size());
    for (const auto &[begin, n, is_ring] : smooth_parts(is_corner, is_closed))
      {
        Part part;
        for (unsigned int i = 0; i <= n; ++i)
          part.points.push_back(points[(begin + i) % points.size()]);
        for (unsigned int i = 0; i < n; ++i)
          part.steps.push_back(part.points[i].distance(part.points[i + 1]));
        const bool   at_start = !is_closed && begin == 0;
        const bool   at_end   = !is_closed && begin + n == segments.size();
        const Ends   clamped  = {{at_start ? tangents[0] : std::nullopt,
                               at_end ? tangents[1] : std::nullopt}};
        const Slopes m =
          is_ring ? ring_slopes(part) : open_slopes(part, clamped);
        for (unsigned int i = 0; i < n; ++i)
          {
            const double third = part.steps[i] / 3.;
            segments[(begin + i) % segments.size()].control = {
              {part.points[i],
               part.points[i] + third * m[i],
               part.points[i + 1] - third * m[i + 1],
               part.points[i + 1]}};
          }
      }
    return Curve(std::move(segments), is_corner, is_closed, ends);
  }
} // namespace Signorini
