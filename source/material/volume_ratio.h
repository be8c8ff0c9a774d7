#ifndef signorini_source_material_volume_ratio_h
#define signorini_source_material_volume_ratio_h

#include <signorini/material/material.h>

namespace Signorini
{
  /**
   * det(1 + H) - 1 of a displacement gradient H, without cancellation where H
   * is small.
   * @throws MaterialFailure unless det(1 + H) > 0.
   */
  inline double
  volume_ratio_minus_one(const dealii::Tensor<2, 3> &H)
  {
    const double minors = H[0][0] * H[1][1] - H[0][1] * H[1][0] +
                          H[1][1] * H[2][2] - H[1][2] * H[2][1] +
                          H[2][2] * H[0][0] - H[2][0] * H[0][2];
    const double change = trace(H) + minors + determinant(H);
    if (!(change > -1.))
      throw MaterialFailure("The ratio of volumes det F must be greater than "
                            "zero, found " +
                            std::to_string(1. + change) + ".");
    return change;
  }
} // namespace Signorini

#endif
