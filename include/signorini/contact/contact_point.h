#ifndef signorini_contact_contact_point_h
#define signorini_contact_contact_point_h

#include <signorini/variational_inequality/interface_problem.h>

#include <deal.II/base/tensor.h>
#include <deal.II/lac/full_matrix.h>

#include <array>
#include <limits>
#include <vector>

namespace Signorini
{
  /** A second derivative of the gap: grad grad g over a few unknowns, 1/m. */
  struct GapCurvature
  {
    std::vector<unsigned int>  unknowns;
    dealii::FullMatrix<double> matrix;
  };

  /**
   * What a candidate contact sees of its target, in terms of the unknowns q of
   * all bodies. Without a target in reach the gap is infinite and all rows are
   * empty.
   */
  template <int dim>
  struct ContactPoint
  {
    double gap = std::numeric_limits<double>::infinity(); // g, m

    double recession = 0.; // of the surfaces by wear, which it contains, m

    // B, over which the contact force is spread, with the thickness or the
    // circumference, m^2. With finite strains that of the deformed surface.
    double area = 0.;

    // Slip over the step along each tangent, m.
    std::array<double, 2> slip = {{0., 0.}};

    SparseRow                      gap_gradient;   // dg/dq, 1
    std::array<SparseRow, dim - 1> slip_gradients; // ds/dq, 1

    // Empty if the gap is linear.
    std::vector<GapCurvature> curvatures;

    // Force on the contactor for a unit force of the contact, and minus that
    // for unit tangential forces, 1.
    dealii::Tensor<1, dim>                      normal;
    std::array<dealii::Tensor<1, dim>, dim - 1> tangents;

    /**
     * Contact pressure under a contact force (N), in Pa. A node that has no
     * area (on the axis, with quadratic elements) gets zero.
     */
    double
    pressure(const double force) const
    {
      return area > 0. ? force / area : 0.;
    }

    /** Adds up the entries of the same unknown. */
    void
    merge_rows();

    bool
    is_in_reach() const
    {
      return gap_gradient.size() > 0;
    }
  };
} // namespace Signorini

#endif
