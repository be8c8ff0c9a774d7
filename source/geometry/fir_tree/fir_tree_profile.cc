#include <signorini/geometry/degrees.h>
#include <signorini/geometry/fir_tree/fir_tree_profile.h>

#include <algorithm>
#include <cmath>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    using Kind = ProfilePiece::Kind;

    // Radii of one of the two profiles, in m.
    struct Radii
    {
      double first_fillet, fillet, tip, bottom;
    };

    // The parts of the joint that both profiles have in common.
    class Skeleton
    {
    public:
      explicit Skeleton(const FirTreeJoint &joint)
        : joint(joint)
        , alpha(joint.contact_angle)
        , beta(joint.back_angle)
        , contact_normal({sin_degrees(alpha), cos_degrees(alpha)})
        , back_normal({sin_degrees(beta), -cos_degrees(beta)})
      {}

      // The corner between rim and slot, y.
      double
      rim() const
      {
        const double mouth = joint.neck(1) + joint.clearance;
        return std::sqrt(joint.rim_radius * joint.rim_radius - mouth * mouth);
      }

      // Where the straight sides of the blade end, y.
      double
      top_of_fillet() const
      {
        return rim() - joint.mouth_depth;
      }

      Point<2>
      inner_end_of_flank(const unsigned int tooth) const
      {
        const Point<2> center(joint.neck(tooth) + joint.root_radius,
                              top_of_fillet() -
                                (tooth - 1) * joint.pitch() *
                                  cos_degrees(joint.taper_angle));
        return center - joint.root_radius * contact_normal;
      }

      Point<2>
      outer_end_of_flank(const unsigned int tooth) const
      {
        return inner_end_of_flank(tooth) +
               joint.flank_length *
                 Tensor<1, 2>({cos_degrees(alpha), -sin_degrees(alpha)});
      }

      Point<2>
      center_of_fillet(const unsigned int tooth, const double radius) const
      {
        return inner_end_of_flank(tooth) + radius * contact_normal;
      }

      Point<2>
      center_of_tip(const unsigned int tooth, const double radius) const
      {
        return outer_end_of_flank(tooth) - radius * contact_normal;
      }

      // The blade's bottom is tangent to its last back flank.
      Point<2>
      center_of_bottom() const
      {
        const Point<2> tip_end =
          center_of_tip(joint.n_teeth, joint.tip_radius) +
          joint.tip_radius * back_normal;
        const double length =
          (tip_end[0] - joint.bottom_radius * back_normal[0]) /
          cos_degrees(beta);
        return Point<2>(0.,
                        tip_end[1] - length * sin_degrees(beta) -
                          joint.bottom_radius * back_normal[1]);
      }

      std::vector<ProfilePiece>
      profile(const Radii &radii, const double top) const;

    private:
      const FirTreeJoint joint;
      const double       alpha, beta;
      const Tensor<1, 2> contact_normal, back_normal; // outwards of the blade
    };



    std::vector<ProfilePiece>
    Skeleton::profile(const Radii &radii, const double top) const
    {
      const auto fillet_radius = [&](const unsigned int tooth) {
        return tooth == 1 ? radii.first_fillet : radii.fillet;
      };
      const Point<2> bottom_center = center_of_bottom();
      const Point<2> bottom_start  = bottom_center + radii.bottom * back_normal;
      const Point<2> first_center  = center_of_fillet(1, radii.first_fillet);
      const Point<2> side_end =
        first_center - Tensor<1, 2>({radii.first_fillet, 0.});

      std::vector<ProfilePiece> pieces = {
        {Kind::side, 1, Point<2>(side_end[0], top), side_end, Point<2>(), 0.}};
      const auto add = [&](const Kind         kind,
                           const unsigned int tooth,
                           const Point<2>    &end,
                           const Point<2>    &center = Point<2>(),
                           const double       turn   = 0.) {
        pieces.push_back({kind, tooth, pieces.back().end, end, center, turn});
      };

      for (unsigned int tooth = 1; tooth <= joint.n_teeth; ++tooth)
        {
          const Point<2> tip_center = center_of_tip(tooth, radii.tip);
          add(Kind::fillet,
              tooth,
              inner_end_of_flank(tooth),
              center_of_fillet(tooth, fillet_radius(tooth)),
              tooth == 1 ? 90. - alpha : joint.tip_turn());
          add(Kind::contact, tooth, outer_end_of_flank(tooth));
          add(Kind::tip,
              tooth,
              tip_center + radii.tip * back_normal,
              tip_center,
              -joint.tip_turn());
          add(Kind::back,
              tooth,
              tooth == joint.n_teeth ?
                bottom_start :
                center_of_fillet(tooth + 1, radii.fillet) -
                  radii.fillet * back_normal);
        }
      add(Kind::bottom,
          joint.n_teeth,
          bottom_center - Tensor<1, 2>({0., radii.bottom}),
          bottom_center,
          -beta);
      return pieces;
    }

    Radii
    slot_radii(const FirTreeJoint &joint)
    {
      const double at_back = joint.radius_difference(joint.tip_turn());
      const double at_side = joint.radius_difference(90. - joint.contact_angle);
      return {joint.root_radius - at_side,
              joint.root_radius - at_back,
              joint.tip_radius + at_back,
              joint.bottom_radius + joint.clearance};
    }
  } // namespace



  bool
  ProfilePiece::is_arc() const
  {
    return turn != 0.;
  }



  double
  ProfilePiece::radius() const
  {
    return start.distance(center);
  }



  Point<2>
  ProfilePiece::at(const double fraction) const
  {
    if (fraction == 0.)
      return start;
    if (fraction == 1.)
      return end;
    if (!is_arc())
      return start + fraction * (end - start);
    const Tensor<1, 2> arm = start - center;
    const double       c   = cos_degrees(fraction * turn);
    const double       s   = sin_degrees(fraction * turn);
    return center +
           Tensor<1, 2>({c * arm[0] - s * arm[1], s * arm[0] + c * arm[1]});
  }



  Tensor<1, 2>
  ProfilePiece::tangent(const double fraction) const
  {
    if (!is_arc())
      return (end - start) / start.distance(end);
    const Tensor<1, 2> arm  = at(fraction) - center;
    const double       sign = turn > 0. ? 1. : -1.;
    return sign / arm.norm() * Tensor<1, 2>({-arm[1], arm[0]});
  }



  ProfilePiece
  ProfilePiece::part(const double begin, const double finish) const
  {
    return {
      kind, tooth, at(begin), at(finish), center, (finish - begin) * turn};
  }



  std::vector<ProfilePiece>
  blade_profile(const FirTreeJoint &joint, const double shank_height)
  {
    const Skeleton skeleton(joint);
    return skeleton.profile({joint.root_radius,
                             joint.root_radius,
                             joint.tip_radius,
                             joint.bottom_radius},
                            skeleton.top_of_fillet() + shank_height);
  }



  std::vector<ProfilePiece>
  slot_profile(const FirTreeJoint &joint)
  {
    const Skeleton skeleton(joint);
    return skeleton.profile(slot_radii(joint), skeleton.rim());
  }



  double
  disc_neck(const FirTreeJoint &joint)
  {
    const double angle = 180. / joint.n_blades;
    double       neck  = joint.rim_radius;
    for (const ProfilePiece &piece : slot_profile(joint))
      if (piece.kind == Kind::tip)
        neck =
          std::min(neck,
                   piece.center[1] * sin_degrees(angle) -
                     piece.center[0] * cos_degrees(angle) - piece.radius());
    return neck;
  }
} // namespace Signorini
