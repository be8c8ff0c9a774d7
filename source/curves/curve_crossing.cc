#include <signorini/curves/curve_crossing.h>

#include <algorithm>
#include <array>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    // Smaller cells ask Newton's method; the smallest ones hold only points
    // that touch, for which it does not converge.
    constexpr double newton_size = 0.02, smallest_size = 1e-6;

    // Paths along the curve have roots everywhere: a limit to the search.
    constexpr unsigned int most_cells = 20000;

    std::vector<BoundingBox<2>>
    swept_boxes(const Curve &start, const Curve &end)
    {
      AssertDimension(start.n_segments(), end.n_segments());
      std::vector<BoundingBox<2>> boxes;
      for (unsigned int s = 0; s < start.n_segments(); ++s)
        {
          boxes.push_back(start.segment(s).box());
          boxes.back().merge_with(end.segment(s).box());
        }
      return boxes;
    }

    // F of one segment, with its coefficients at both ends of the step.
    struct SegmentMotion
    {
      BezierSegment start, end;

      SegmentMotion(const BezierSegment &first,
                    const BezierSegment &last,
                    const Point<2>      &x,
                    const Point<2>      &X)
        : start(first)
        , end(last)
      {
        for (unsigned int i = 0; i < 4; ++i)
          {
            start.control[i] -= Tensor<1, 2>(x);
            end.control[i] -= Tensor<1, 2>(X);
          }
      }

      Tensor<1, 2>
      value(const double xi, const double t) const
      {
        return (1. - t) * Tensor<1, 2>(start.value(xi)) +
               t * Tensor<1, 2>(end.value(xi));
      }

      Tensor<1, 2>
      slope(const double xi, const double t) const
      {
        return (1. - t) * start.derivative(xi) + t * end.derivative(xi);
      }

      Tensor<1, 2>
      rate(const double xi) const
      {
        return end.value(xi) - start.value(xi);
      }
    };

    struct Cell
    {
      BezierSegment start, end; // coefficients of F on this cell
      double        xi, t;      // its lower corner
      double        xi_size, t_size;
    };

    bool
    may_hold_a_root(const Cell &cell, const double rounding)
    {
      for (unsigned int d = 0; d < 2; ++d)
        {
          double low = cell.start.control[0][d], high = low;
          for (const auto *side : {&cell.start, &cell.end})
            for (const auto &point : side->control)
              {
                low  = std::min(low, point[d]);
                high = std::max(high, point[d]);
              }
          if (low > rounding || high < -rounding)
            return false;
        }
      return true;
    }

    std::array<Cell, 2>
    halves(const Cell &cell)
    {
      Cell low = cell, high = cell;
      if (cell.xi_size >= cell.t_size)
        {
          std::tie(low.start, high.start) = cell.start.split(0.5);
          std::tie(low.end, high.end)     = cell.end.split(0.5);
          low.xi_size = high.xi_size = 0.5 * cell.xi_size;
          high.xi += low.xi_size;
        }
      else
        {
          for (unsigned int i = 0; i < 4; ++i)
            low.end.control[i] = high.start.control[i] =
              cell.start.control[i] +
              0.5 * (cell.end.control[i] - cell.start.control[i]);
          low.t_size = high.t_size = 0.5 * cell.t_size;
          high.t += low.t_size;
        }
      return {{low, high}};
    }

    // Newton's method from the middle of a cell to a root in it. One beside it
    // belongs to another cell, and must not hide the one of this cell.
    bool
    find_root(const SegmentMotion &motion,
              const Cell          &cell,
              double              &xi,
              double              &t)
    {
      xi = cell.xi + 0.5 * cell.xi_size;
      t  = cell.t + 0.5 * cell.t_size;
      for (unsigned int step = 0; step < 12; ++step)
        {
          const Tensor<1, 2> f = motion.value(xi, t);
          const Tensor<1, 2> a = motion.slope(xi, t), b = motion.rate(xi);
          const double       determinant = a[0] * b[1] - a[1] * b[0];
          if (std::abs(determinant) <= 1e-14 * a.norm() * b.norm())
            return false;
          const double dxi = -(f[0] * b[1] - f[1] * b[0]) / determinant;
          const double dt  = -(a[0] * f[1] - a[1] * f[0]) / determinant;
          xi += dxi;
          t += dt;
          if (std::abs(xi - cell.xi - 0.5 * cell.xi_size) > cell.xi_size ||
              std::abs(t - cell.t - 0.5 * cell.t_size) > cell.t_size)
            return false;
          if (std::abs(dxi) + std::abs(dt) < 1e-12)
            return std::abs(xi - cell.xi - 0.5 * cell.xi_size) <
                     0.5 * cell.xi_size + 1e-10 &&
                   std::abs(t - cell.t - 0.5 * cell.t_size) <
                     0.5 * cell.t_size + 1e-10;
        }
      return false;
    }

    void
    search(const SegmentMotion     &motion,
           const unsigned int       segment,
           std::optional<Crossing> &first)
    {
      double scale = 0.;
      for (const auto *side : {&motion.start, &motion.end})
        for (const auto &point : side->control)
          scale = std::max(scale, point.norm());
      std::vector<Cell> cells   = {{motion.start, motion.end, 0., 0., 1., 1.}};
      unsigned int      visited = 0;
      while (!cells.empty() && ++visited < most_cells)
        {
          const Cell cell = cells.back();
          cells.pop_back();
          if ((first && cell.t >= first->fraction) ||
              !may_hold_a_root(cell, 1e-14 * scale))
            continue;
          double     xi = 0., t = 0.;
          const bool is_small =
            std::max(cell.xi_size, cell.t_size) < newton_size;
          if (is_small && find_root(motion, cell, xi, t))
            {
              const Tensor<1, 2> normal =
                normal_of_tangent(motion.slope(xi, t));
              // F is the curve seen from the point: it moves outwards.
              if (motion.rate(xi) * normal > 0. &&
                  (!first || t < first->fraction))
                first = Crossing{std::clamp(t, 0., 1.),
                                 {segment, std::clamp(xi, 0., 1.)}};
              continue;
            }
          if (std::max(cell.xi_size, cell.t_size) < smallest_size)
            continue;
          // The earlier half comes first.
          const auto [low, high] = halves(cell);
          cells.push_back(high);
          cells.push_back(low);
        }
    }
  } // namespace



  CurveCrossing::CurveCrossing(const Curve &start, const Curve &end)
    : start_(&start)
    , end_(&end)
    , tree_(swept_boxes(start, end))
  {}



  CurveCrossing::CurveCrossing(const Curve &curve)
    : CurveCrossing(curve, curve)
  {}



  std::optional<Crossing>
  CurveCrossing::first(const Point<2> &start, const Point<2> &end) const
  {
    Point<2> lower, upper;
    for (unsigned int d = 0; d < 2; ++d)
      {
        lower[d] = std::min(start[d], end[d]);
        upper[d] = std::max(start[d], end[d]);
      }
    std::vector<unsigned int> near;
    tree_.find(lower, upper, near);
    std::optional<Crossing> first;
    for (const unsigned int s : near)
      search(SegmentMotion(start_->segment(s), end_->segment(s), start, end),
             s,
             first);
    return first;
  }
} // namespace Signorini
