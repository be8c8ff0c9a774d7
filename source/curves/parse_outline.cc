#include <signorini/curves/outline.h>
#include <signorini/curves/parse_outline.h>
#include <signorini/input/input_error.h>
#include <signorini/input/named_list.h>

#include <deal.II/base/utilities.h>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    // Draws one item that begins with a keyword; false if it is none.
    bool
    draw_arc(const std::string &item,
             const std::string &entry,
             Outline           &outline)
    {
      for (const std::string keyword : {"arc ", "left about ", "right about "})
        {
          if (item.compare(0, keyword.size(), keyword) != 0)
            continue;
          const auto to = item.find(" to ");
          if (to == std::string::npos)
            throw InputError(entry,
                             "\"" + item + "\" says not where it " +
                               "ends: \"" + keyword + "a, b to x, y\" is " +
                               "allowed.");
          const Point<2> point =
            parse_point<2>(item.substr(keyword.size(), to - keyword.size()),
                           entry);
          const Point<2> end = parse_point<2>(item.substr(to + 4), entry);
          if (keyword == "arc ")
            outline.arc_through(point, end);
          else
            outline.arc_about(point, end, keyword == "left about ");
          return true;
        }
      return false;
    }
  } // namespace



  Curve
  parse_outline(const std::string &text,
                const bool         is_closed,
                const double       feature_angle,
                const std::string &entry)
  {
    const auto items = split_list(text, ';');
    Outline    outline(parse_point<2>(items.at(0), entry));
    // What the outline itself refuses does not know the entry yet.
    try
      {
        for (unsigned int i = 1; i < items.size(); ++i)
          if (!draw_arc(items[i], entry, outline))
            outline.line_to(parse_point<2>(items[i], entry));
        return outline.curve(is_closed, feature_angle);
      }
    catch (const InputError &error)
      {
        throw error.entry().empty() ? InputError(entry, error.text()) : error;
      }
  }
} // namespace Signorini
