#include <signorini/geometry/degrees.h>
#include <signorini/geometry/fir_tree/fir_tree_layer.h>

#include <algorithm>
#include <cmath>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    double
    cross(const Tensor<1, 2> &a, const Tensor<1, 2> &b)
    {
      return a[0] * b[1] - a[1] * b[0];
    }
  } // namespace



  unsigned int
  n_half_first_fillet(const FirTreeJoint &joint, const unsigned int n_fillet)
  {
    const double n =
      0.5 * n_fillet * (90. - joint.contact_angle) / joint.tip_turn();
    return static_cast<unsigned int>(std::ceil(n - 1e-9));
  }



  Point<2>
  inner_point(const ProfilePiece &piece,
              const bool          body_is_left,
              const double        thickness,
              const double        lean)
  {
    const Tensor<1, 2> along  = piece.tangent(0.);
    const double       sign   = body_is_left ? 1. : -1.;
    const Tensor<1, 2> normal = sign * Tensor<1, 2>({-along[1], along[0]});
    return piece.start +
           thickness * (cos_degrees(lean) * normal + sin_degrees(lean) * along);
  }



  double
  layer_in_tooth(const ProfilePiece &first, const ProfilePiece &second)
  {
    const Tensor<1, 2> base  = second.end - first.start;
    const Tensor<1, 2> along = first.tangent(0.);
    const Tensor<1, 2> back  = second.tangent(0.);
    const double       height =
      std::min(std::abs(cross(along, base)), std::abs(cross(back, base)));
    // Moving the other flank takes this part of the height as well.
    return 0.5 * height / (1. + std::max(0., -(along * back)));
  }



  double
  layer_at_tip(const FirTreeJoint &joint,
               const double        radius,
               const double        layer)
  {
    const double flank =
      std::min(joint.flank_length, joint.back_flank_length());
    return std::min(
      {0.45 * radius, layer, 0.3 * flank / sin_degrees(lean_at_tip(joint))});
  }



  double
  lean_at_tip(const FirTreeJoint &joint)
  {
    return joint.tip_turn() / 6.;
  }
} // namespace Signorini
