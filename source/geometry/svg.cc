#include "svg.h"

#include <cmath>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    long
    whole(const double coordinate)
    {
      return std::lround(std::floor(coordinate + 0.501));
    }

    enum class Anchor
    {
      start,
      middle,
      end
    };

    Anchor
    anchor_of(const Tensor<1, 2> &direction)
    {
      return direction[0] > 0.4  ? Anchor::start :
             direction[0] < -0.4 ? Anchor::end :
                                   Anchor::middle;
    }

    // A minus parts numbers as well as a blank does.
    std::string
    after(const long number)
    {
      return (number < 0 ? "" : " ") + std::to_string(number);
    }
  } // namespace



  std::string
  svg_path(const std::vector<Point<2>> &points)
  {
    std::string text;
    long        x = 0, y = 0;
    for (const Point<2> &point : points)
      {
        const long next_x = whole(point[0]), next_y = whole(point[1]);
        text += (text.empty() ? "M" : "l") + std::to_string(next_x - x) +
                after(next_y - y);
        x = next_x;
        y = next_y;
      }
    return text;
  }



  std::string
  svg_text(const SvgWords &words, const double font_size)
  {
    const std::string anchors[] = {"start", "middle", "end"};
    // Letters stand on their place.
    return "<text x=\"" + std::to_string(whole(words.place[0])) + "\" y=\"" +
           std::to_string(whole(words.place[1] + 0.35 * font_size)) +
           "\" fill=\"" + words.colour + "\" text-anchor=\"" +
           anchors[static_cast<int>(anchor_of(words.direction))] + "\">" +
           words.words + "</text>\n";
  }



  std::pair<Point<2>, Point<2>>
  svg_box(const SvgWords &words, const double font_size)
  {
    const double width = 0.58 * font_size * words.words.size();
    const double left =
      words.place[0] -
      0.5 * width * static_cast<int>(anchor_of(words.direction));
    return {Point<2>(left, words.place[1] - 0.6 * font_size),
            Point<2>(left + width, words.place[1] + 0.6 * font_size)};
  }
} // namespace Signorini
