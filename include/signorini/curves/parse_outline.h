#ifndef signorini_curves_parse_outline_h
#define signorini_curves_parse_outline_h

#include <signorini/curves/curve.h>

#include <string>

namespace Signorini
{
  /**
   * Draws an outline from a list such as
   *
   *   0, 0 ; 1, 0 ; arc 1.5, 0.5 to 1, 1 ; left about 0.5, 1 to 0, 1
   *
   * Each item goes on from the end of the last one: `x, y` is a straight line
   * to there (the first one: the start), `arc a, b to x, y` the circular arc
   * through a, b, `left about a, b to x, y` or `right about a, b to x, y` the
   * one about the centre a, b that turns to the left (counterclockwise) or to
   * the right. Unit: m.
   * @throws InputError.
   */
  Curve
  parse_outline(const std::string &text,
                const bool         is_closed,
                const double       feature_angle,
                const std::string &entry);
} // namespace Signorini

#endif
