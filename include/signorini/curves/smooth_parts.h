#ifndef signorini_curves_smooth_parts_h
#define signorini_curves_smooth_parts_h

#include <deal.II/base/point.h>

#include <vector>

namespace Signorini
{
  /** Segments of a chain between two corners. */
  struct SmoothPart
  {
    unsigned int begin; // first segment
    unsigned int n_segments;
    bool         is_ring; // closed without a corner
  };

  /**
   * For each segment of a polygon whether it turns by more than the angle where
   * the segment ends. Segment s goes from point s to point s + 1.
   * @param feature_angle degrees
   */
  std::vector<bool>
  corners_of_polygon(const std::vector<dealii::Point<2>> &points,
                     const bool                           is_closed,
                     const double                         feature_angle);

  /** The chain cut at its corners, in its order. */
  std::vector<SmoothPart>
  smooth_parts(const std::vector<bool> &is_corner, const bool is_closed);

  /**
   * @throws InputError for less than two points (closed: three) or neighbours
   * at the same place.
   */
  void
  check_polygon(const std::vector<dealii::Point<2>> &points,
                const bool                           is_closed);
} // namespace Signorini

#endif
