#ifndef signorini_contact_profile_h
#define signorini_contact_profile_h

#include <signorini/contact/rigid_surface.h>
#include <signorini/curves/curve_search.h>

#include <memory>
#include <string>

namespace Signorini
{
  /**
   * A rigid target bounded by a curve: a spline or straight segments through
   * points, or an outline of straight lines and circular arcs.
   *
   * The gap is the distance from the nearest point of the curve, negative on
   * the side of the body. Beyond the end of an open curve it is the distance
   * from that end, positive on both sides: the curve has to reach as far as
   * bodies may come.
   */
  class Profile : public RigidSurface<2>
  {
  public:
    /** @param curve with the body on its left */
    explicit Profile(Curve curve);

    Profile(const Profile &) = delete;
    Profile &
    operator=(const Profile &) = delete;

    static void
    declare_parameters(dealii::ParameterHandler &prm);

    /**
     * @param directory where the path of `File` starts
     * @throws InputError.
     */
    static std::unique_ptr<RigidSurface<2>>
    create(dealii::ParameterHandler &prm,
           const std::string        &section,
           const std::string        &directory);

    /**
     * grad grad g = -n.y''/(|y'|^2 - g n.y'') t t above the curve and
     * (I - n n)/g above a vertex.
     */
    SurfacePoint<2>
    closest(const dealii::Point<2> &point) const override;

    bool
    is_flat() const override;

    std::vector<dealii::Point<2>>
    outline() const override;

    const Curve &
    curve() const
    {
      return curve_;
    }

  private:
    Curve       curve_;
    CurveSearch search_;
  };
} // namespace Signorini

#endif
