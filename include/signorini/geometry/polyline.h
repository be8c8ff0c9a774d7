#ifndef signorini_geometry_polyline_h
#define signorini_geometry_polyline_h

#include <deal.II/base/point.h>

#include <vector>

namespace Signorini
{
  /** The vertices of a mesh along one edge of a patch. */
  using Polyline = std::vector<dealii::Point<2>>;

  /**
   * @p n + 1 numbers from 0 to 1 whose differences form a geometric sequence
   * that begins with @p first, or equal ones if there is no room for growing;
   * the last one is at most 50 times the first one.
   */
  std::vector<double>
  growing_fractions(const unsigned int n, const double first);

  /** @p n + 1 numbers from 0 to 1 at equal distances. */
  std::vector<double>
  equal_fractions(const unsigned int n);

  Polyline
  straight_line(const dealii::Point<2>    &start,
                const dealii::Point<2>    &end,
                const std::vector<double> &fractions);

  /**
   * The arc about @p center from @p start to @p end, shorter than half a
   * circle, both at the same distance from the centre.
   */
  Polyline
  arc(const dealii::Point<2>    &start,
      const dealii::Point<2>    &end,
      const dealii::Point<2>    &center,
      const std::vector<double> &fractions);

  /**
   * The parabola that leaves @p start towards @p control and ends in @p end.
   * The fractions are those of its length, up to a part in a thousand.
   */
  Polyline
  parabola(const dealii::Point<2>    &start,
           const dealii::Point<2>    &control,
           const dealii::Point<2>    &end,
           const std::vector<double> &fractions);

  Polyline
  reversed(const Polyline &line);

  /** The point with -x for x. */
  dealii::Point<2>
  mirrored(const dealii::Point<2> &point);

  /** Its points with -x for x, in the same order. */
  Polyline
  mirrored(Polyline line);

  /** Two lines, the second of which begins where the first one ends. */
  Polyline
  joined(const Polyline &first, const Polyline &second);

  /** The position of each point along the line, from 0 to 1. */
  std::vector<double>
  positions_along(const Polyline &line);
} // namespace Signorini

#endif
