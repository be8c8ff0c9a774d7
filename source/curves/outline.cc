#include <signorini/curves/outline.h>
#include <signorini/input/input_error.h>

#include <deal.II/base/numbers.h>

#include <cmath>
#include <sstream>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    constexpr double largest_piece = 6. * numbers::PI / 180.;

    std::string
    in_words(const Point<2> &point)
    {
      std::ostringstream words;
      words << '(' << point[0] << ", " << point[1] << ')';
      return words.str();
    }

    double
    cross(const Tensor<1, 2> &a, const Tensor<1, 2> &b)
    {
      return a[0] * b[1] - a[1] * b[0];
    }
  } // namespace



  Outline::Outline(const Point<2> &start)
    : start_(start)
    , end_(start)
  {}



  void
  Outline::line_to(const Point<2> &end)
  {
    if (end.distance(end_) == 0.)
      throw InputError("two points that follow each other lie at the same "
                       "place, " +
                       in_words(end) + ", in m; leave out one of them.");
    segments_.push_back(BezierSegment::line(end_, end));
    end_ = end;
  }



  void
  Outline::arc_through(const Point<2> &middle, const Point<2> &end)
  {
    const Tensor<1, 2> a = middle - end_, b = end - end_;
    const double       area = cross(a, b); // twice the triangle's
    if (std::abs(area) <= 1e-12 * a.norm() * b.norm())
      throw InputError("the arc from " + in_words(end_) + " through " +
                       in_words(middle) + " to " + in_words(end) +
                       " (m) is a straight line: three points of an arc must "
                       "not lie on one line.");
    Tensor<1, 2> arm; // from here to the centre
    arm[0] = (b[1] * a.norm_square() - a[1] * b.norm_square()) / (2. * area);
    arm[1] = (a[0] * b.norm_square() - b[0] * a.norm_square()) / (2. * area);
    arc_about(end_ + arm, end, area > 0.);
  }



  void
  Outline::arc_about(const Point<2> &centre,
                     const Point<2> &end,
                     const bool      counterclockwise)
  {
    const Tensor<1, 2> from = end_ - centre, to = end - centre;
    const double       radius = from.norm();
    if (radius == 0. || std::abs(to.norm() - radius) > 1e-6 * radius)
      {
        std::ostringstream message;
        message << "the arc about " << in_words(centre) << " begins at "
                << in_words(end_) << ", at a distance of " << radius
                << " m from its centre, and ends at " << in_words(end)
                << ", at a distance of " << to.norm()
                << " m: both must be the radius.";
        throw InputError(message.str());
      }
    double angle = std::atan2(cross(from, to), from * to);
    if (counterclockwise && angle <= 0.)
      angle += 2. * numbers::PI;
    if (!counterclockwise && angle >= 0.)
      angle -= 2. * numbers::PI;

    const unsigned int n =
      std::max(1., std::ceil(std::abs(angle) / largest_piece - 1e-9));
    const double handle = 4. / 3. * std::tan(angle / n / 4.);
    const auto   arm_at = [&](const unsigned int i) {
      const double c = std::cos(angle * i / n), s = std::sin(angle * i / n);
      Tensor<1, 2> arm;
      arm[0] = c * from[0] - s * from[1];
      arm[1] = s * from[0] + c * from[1];
      return arm;
    };
    for (unsigned int i = 0; i < n; ++i)
      {
        const Tensor<1, 2> first = arm_at(i), last = arm_at(i + 1);
        BezierSegment      piece;
        piece.control[0] = i == 0 ? end_ : segments_.back().control[3];
        piece.control[3] = i + 1 == n ? end : centre + last;
        piece.control[1] = piece.control[0] + handle * tangent_of_normal(first);
        piece.control[2] = piece.control[3] - handle * tangent_of_normal(last);
        segments_.push_back(piece);
      }
    end_ = end;
  }



  Curve
  Outline::curve(const bool                     is_closed,
                 const double                   feature_angle,
                 const std::array<CurveEnd, 2> &ends) const
  {
    Outline drawn = *this;
    if (is_closed && end_.distance(start_) > 0.)
      drawn.line_to(start_);
    if (drawn.segments_.empty())
      throw InputError("a curve needs at least 2 points, found 1.");
    const auto is_corner =
      corners_between(drawn.segments_, is_closed, feature_angle);
    return Curve(drawn.segments_, is_corner, is_closed, ends);
  }



  Curve
  circle(const Point<2> &centre, const double radius)
  {
    const Point<2> start = centre + Point<2>(radius, 0.);
    Outline        outline(start);
    outline.arc_about(centre, start, true);
    return outline.curve(true, 30.);
  }
} // namespace Signorini
