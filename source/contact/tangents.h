#ifndef signorini_contact_tangents_h
#define signorini_contact_tangents_h

#include <deal.II/base/tensor.h>

#include <array>
#include <cmath>

namespace Signorini
{
  /**
   * Unit vectors that make an orthonormal frame with a unit normal: in 2-D the
   * normal turned a quarter counter-clockwise, so that a target's body lies on
   * the left of t; in 3-D with t_1 x t_2 = n.
   */
  template <int dim>
  std::array<dealii::Tensor<1, dim>, dim - 1>
  tangents_of(const dealii::Tensor<1, dim> &normal)
  {
    std::array<dealii::Tensor<1, dim>, dim - 1> tangents;
    if constexpr (dim == 2)
      {
        tangents[0][0] = -normal[1];
        tangents[0][1] = normal[0];
      }
    else
      {
        // x or, where the normal is near to it, y. The choice must not hang on
        // rounding at normals along an axis: the frame would turn from one
        // iteration to the next.
        const unsigned int axis = std::abs(normal[0]) < 0.9 ? 0 : 1;
        tangents[0][axis]       = 1.;
        tangents[0] -= normal[axis] * normal;
        tangents[0] /= tangents[0].norm();
        tangents[1] = dealii::cross_product_3d(normal, tangents[0]);
      }
    return tangents;
  }
} // namespace Signorini

#endif
