#include <signorini/contact/profile.h>
#include <signorini/curves/c2_spline.h>
#include <signorini/curves/curve_weights.h>
#include <signorini/curves/outline.h>
#include <signorini/curves/parse_outline.h>
#include <signorini/curves/point_table.h>
#include <signorini/input/input_error.h>
#include <signorini/input/named_list.h>
#include <signorini/input/number_text.h>

#include <deal.II/base/parameter_handler.h>

#include <filesystem>
#include <utility>

namespace Signorini
{
  using namespace dealii;

  Profile::Profile(Curve curve)
    : curve_(std::move(curve))
    , search_(curve_)
  {}



  void
  Profile::declare_parameters(ParameterHandler &prm)
  {
    prm.enter_subsection("Profile");
    prm.declare_entry("Points",
                      "",
                      NumberText(),
                      "The points of the curve in their order, `x, y ; x, y ; "
                      "...'. Give one of Points, File and Outline. Unit: m.");
    prm.declare_entry("File",
                      "",
                      Patterns::Anything(),
                      "A text file with the points, two columns x and y; what "
                      "follows a # is a comment. Unit: m.");
    prm.declare_entry("Outline",
                      "",
                      NumberText({"arc", "left", "right", "about", "to"}),
                      "Lines and arcs, one after the other: `0, 0 ; 1, 0 ; arc "
                      "1.5, 0.5 to 1, 1 ; left about 0.5, 1 to 0, 1'. `x, y' "
                      "is a straight line to there, `arc a, b to x, y' an arc "
                      "through a, b, `left about a, b to x, y' (or `right') an "
                      "arc about the centre a, b that turns left (right). "
                      "Unit: m.");
    prm.declare_entry("Curve",
                      "spline",
                      Patterns::Selection("spline|segments"),
                      "How Points and File are joined: by a spline with "
                      "continuous curvature, or by straight segments.");
    prm.declare_entry("Closed",
                      "false",
                      Patterns::Bool(),
                      "The curve returns to its first point, which is not "
                      "repeated.");
    prm.declare_entry("Feature angle",
                      "30",
                      Patterns::Double(0., 180.),
                      "A spline is broken into two where its points turn by "
                      "more, so that it has a corner there. 180: no corners. "
                      "Unit: degrees.");
    prm.declare_entry("Solid side",
                      "left",
                      Patterns::Selection("left|right|within|around"),
                      "Where the rigid body is: left or right of who walks "
                      "along the curve in the order of its points, or, if it "
                      "is closed, within the curve or around it, as of a "
                      "hole.");
    prm.leave_subsection();
  }



  namespace
  {
    // The entries of the section, as they stand.
    struct Description
    {
      std::string points, file, outline, solid_side;
      bool        is_spline, is_closed;
      double      feature_angle;
    };

    Description
    read(ParameterHandler &prm)
    {
      prm.enter_subsection("Profile");
      const Description result = {prm.get("Points"),
                                  prm.get("File"),
                                  prm.get("Outline"),
                                  prm.get("Solid side"),
                                  prm.get("Curve") == "spline",
                                  prm.get_bool("Closed"),
                                  prm.get_double("Feature angle")};
      prm.leave_subsection();
      return result;
    }

    std::string
    resolved(const std::string &file, const std::string &directory)
    {
      return (std::filesystem::path(directory) / file).string();
    }

    Curve
    draw(const Description &description,
         const std::string &path,
         const std::string &directory)
    {
      const bool         is_closed     = description.is_closed;
      const double       feature_angle = description.feature_angle;
      const unsigned int n_given       = !description.points.empty() +
                                   !description.file.empty() +
                                   !description.outline.empty();
      if (n_given != 1)
        throw InputError(
          path + "Points",
          "exactly one of Points, File and Outline describes the curve, found "
          "" +
            (n_given == 0 ? "none of them." : std::to_string(n_given) + "."));
      if (!description.outline.empty())
        return parse_outline(description.outline,
                             is_closed,
                             feature_angle,
                             path + "Outline");

      std::vector<Point<2>> points;
      std::string           entry = path + "Points";
      if (description.file.empty())
        for (const auto &item : split_list(description.points, ';'))
          points.push_back(parse_point<2>(item, entry));
      else
        {
          entry = path + "File";
          points =
            read_point_table(resolved(description.file, directory), entry);
        }
      try
        {
          return description.is_spline ?
                   c2_spline(points, is_closed, feature_angle) :
                   CurveWeights::facets(points, is_closed).curve(points);
        }
      catch (const InputError &error)
        {
          throw InputError(entry, error.text());
        }
    }

    // The curve walked so that the body is on its left.
    Curve
    oriented(const Curve       &curve,
             const std::string &side,
             const std::string &path)
    {
      const std::string entry = path + "Solid side";
      if (side == "right")
        return curve.reversed();
      if (side == "left")
        {
          if (curve.is_closed() && curve.enclosed_area() < 0.)
            throw InputError(
              entry,
              "the closed curve runs clockwise, so that the body on "
              "its left would be everything around it. Set it to "
              "within for a solid outline, or to around for a hole.");
          return curve;
        }
      if (!curve.is_closed())
        throw InputError(entry,
                         "found " + side +
                           ", but the curve is open: left or right is allowed, "
                           "or set Closed = true.");
      return (curve.enclosed_area() > 0.) == (side == "within") ?
               curve :
               curve.reversed();
    }
  } // namespace



  std::unique_ptr<RigidSurface<2>>
  Profile::create(ParameterHandler  &prm,
                  const std::string &section,
                  const std::string &directory)
  {
    const std::string path        = section + " / Profile / ";
    const Description description = read(prm);
    return std::make_unique<Profile>(oriented(
      draw(description, path, directory), description.solid_side, path));
  }



  SurfacePoint<2>
  Profile::closest(const Point<2> &x) const
  {
    const SymmetricTensor<2, 2> unit  = unit_symmetric_tensor<2>();
    const auto                  found = search_.project(x);
    SurfacePoint<2>             result;
    result.gap = std::numeric_limits<double>::infinity();
    if (found)
      {
        result.gap          = found->gap;
        result.normal       = found->normal;
        const double square = found->speed * found->speed;
        const double distance =
          std::max(square - found->gap * found->curvature, 1e-8 * square);
        if (!found->is_vertex)
          result.curvature =
            -found->curvature / distance *
            symmetrize(outer_product(found->tangent, found->tangent));
        else if (found->gap != 0.)
          result.curvature =
            (unit - symmetrize(outer_product(found->normal, found->normal))) /
            found->gap;
      }
    if (curve_.is_closed())
      return result;
    // Beyond an end that is nearer than what was found.
    for (const unsigned int which : {0, 1})
      {
        const CurveParameter place =
          which == 0 ? CurveParameter{0, 0.} :
                       CurveParameter{curve_.n_segments() - 1, 1.};
        const Tensor<1, 2> arm    = x - curve_.value(place);
        const double       beyond = arm * curve_.tangent(place);
        if ((which == 0 ? -beyond : beyond) <= 0. ||
            arm.norm() >= std::abs(result.gap) * (1. - 1e-9))
          continue;
        result.gap    = arm.norm();
        result.normal = arm / arm.norm();
        result.curvature =
          (unit - symmetrize(outer_product(result.normal, result.normal))) /
          result.gap;
      }
    return result;
  }



  std::vector<Point<2>>
  Profile::outline() const
  {
    constexpr unsigned int n_pieces = 8; // a segment
    std::vector<Point<2>>  points;
    for (unsigned int s = 0; s < curve_.n_segments(); ++s)
      for (unsigned int i = 0; i < n_pieces; ++i)
        points.push_back(curve_.value({s, double(i) / n_pieces}));
    points.push_back(curve_.value({curve_.n_segments() - 1, 1.}));
    return points;
  }



  bool
  Profile::is_flat() const
  {
    return false;
  }
} // namespace Signorini
