#ifndef signorini_curves_gap_derivatives_h
#define signorini_curves_gap_derivatives_h

#include <signorini/curves/curve_projection.h>
#include <signorini/curves/curve_weights.h>

#include <deal.II/lac/full_matrix.h>

#include <vector>

namespace Signorini
{
  /**
   * How the gap and the nearest point of a curve through nodes change with the
   * contactor point x and the nodes q_1 ... q_L of the segment. The unknowns
   * are ordered x_0, x_1, q_1,0, q_1,1, ..., the nodes as in the weights.
   */
  struct GapDerivatives
  {
    std::vector<double>        gap;       // dg, 1
    std::vector<double>        parameter; // dxi, 1/m
    dealii::FullMatrix<double> hessian;   // d^2 g, 1/m
  };

  /**
   * With w = dx - sum_j phi_j dq_j, w' = sum_j phi'_j dq_j and
   * D = |y'|^2 - g n.y'', which is positive where the distance is least:
   *
   *   dg    = n.w
   *   dxi   = (w.y' + g n.w') / D
   *   d^2 g = (g (n.w')(n.w') - (n.y'') D dxi dxi
   *            - D ((n.w') dxi + dxi (n.w'))) / |y'|^2
   *
   * from the derivatives of (x - y).y' = 0, n.y' = 0 and g = (x - y).n. At a
   * vertex dxi = 0 and d^2 g = w.(I - n n).w / g, with zero for g = 0.
   *
   * At the centre of curvature D = 0 and the nearest point is not unique. It is
   * kept above 1e-8 |y'|^2 so that the numbers stay finite.
   */
  GapDerivatives
  differentiate_gap(const CurveProjection &projection,
                    const NodalWeights    &weights);
} // namespace Signorini

#endif
