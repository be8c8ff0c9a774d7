#ifndef signorini_geometry_gears_tooth_manifold_h
#define signorini_geometry_gears_tooth_manifold_h

#include <signorini/geometry/gears/tooth_row.h>

#include <deal.II/grid/manifold.h>

#include <memory>

namespace Signorini
{
  /**
   * Puts new vertices of boundary lines on the profile of the teeth, at the
   * mean of the arc lengths of the line's ends.
   */
  class ToothManifold : public dealii::Manifold<2>
  {
  public:
    explicit ToothManifold(const RowProfile &profile);

    std::unique_ptr<dealii::Manifold<2>>
    clone() const override;

    dealii::Point<2>
    get_new_point(
      const dealii::ArrayView<const dealii::Point<2>> &points,
      const dealii::ArrayView<const double>           &weights) const override;

    dealii::Tensor<1, 2>
    get_tangent_vector(const dealii::Point<2> &from,
                       const dealii::Point<2> &to) const override;

  private:
    RowProfile profile;
  };
} // namespace Signorini

#endif
