#ifndef signorini_contact_rigid_placement_h
#define signorini_contact_rigid_placement_h

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

namespace Signorini
{
  /**
   * Where a rigid body is: x = c + u + R (X - c), with the centre c in the
   * position in which its shape is described.
   */
  template <int dim>
  struct RigidPlacement
  {
    dealii::Point<dim>     centre;      // c, m
    dealii::Tensor<1, dim> translation; // u, m
    dealii::Tensor<2, dim> rotation;    // R
    double                 angle = 0.;  // of R, with all whole turns

    dealii::Point<dim>
    to_space(const dealii::Point<dim> &body_point) const
    {
      return centre + translation + rotation * (body_point - centre);
    }

    dealii::Point<dim>
    to_body(const dealii::Point<dim> &space_point) const
    {
      return centre +
             transpose(rotation) * (space_point - centre - translation);
    }
  };

  /** Counter-clockwise by an angle in the plane; in 3-D about z. */
  template <int dim>
  dealii::Tensor<2, dim>
  rotation_by(const double angle)
  {
    dealii::Tensor<2, dim> rotation;
    for (unsigned int d = 0; d < dim; ++d)
      rotation[d][d] = 1.;
    rotation[0][0] = rotation[1][1] = std::cos(angle);
    rotation[1][0]                  = std::sin(angle);
    rotation[0][1]                  = -std::sin(angle);
    return rotation;
  }

  /** e_z x a: a quarter turn counter-clockwise. */
  template <int dim>
  dealii::Tensor<1, dim>
  quarter_turn(const dealii::Tensor<1, dim> &a)
  {
    dealii::Tensor<1, dim> turned;
    turned[0] = -a[1];
    turned[1] = a[0];
    return turned;
  }
} // namespace Signorini

#endif
