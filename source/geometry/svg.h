#ifndef signorini_geometry_svg_h
#define signorini_geometry_svg_h

#include <deal.II/base/point.h>

#include <string>
#include <vector>

namespace Signorini
{
  /**
   * Lines through points as the text of a path, `M10 20l5 0'. Coordinates are
   * whole: what lies between two of them but for rounding always goes the same
   * way.
   */
  std::string
  svg_path(const std::vector<dealii::Point<2>> &points);

  /**
   * Words of a picture.
   * @param place of the middle of their side that @p direction comes from, a
   *              unit vector; of their middle if it is zero
   */
  struct SvgWords
  {
    std::string          words;
    dealii::Point<2>     place;
    dealii::Tensor<1, 2> direction;
    std::string          colour;
  };

  std::string
  svg_text(const SvgWords &words, const double font_size);

  /** About the box that words take up: its lower left and upper right. */
  std::pair<dealii::Point<2>, dealii::Point<2>>
  svg_box(const SvgWords &words, const double font_size);
} // namespace Signorini

#endif
