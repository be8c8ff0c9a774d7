#ifndef signorini_source_geometry_outward_normal_h
#define signorini_source_geometry_outward_normal_h

#include <deal.II/base/tensor.h>

namespace Signorini
{
  /** Unit normal of a face between its corners, away from a point inside. */
  template <int dim, typename Face>
  dealii::Tensor<1, dim>
  outward_normal(const Face &face, const dealii::Point<dim> &inside)
  {
    dealii::Tensor<1, dim> normal;
    if constexpr (dim == 2)
      normal = dealii::cross_product_2d(face->vertex(1) - face->vertex(0));
    else
      normal = dealii::cross_product_3d(face->vertex(3) - face->vertex(0),
                                        face->vertex(2) - face->vertex(1));
    normal /= normal.norm();
    return normal * (face->center() - inside) > 0. ? normal : -normal;
  }
} // namespace Signorini

#endif
