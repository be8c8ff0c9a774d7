#include <signorini/curves/gap_derivatives.h>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    // d.w and d.w' for a fixed direction d, as rows over the unknowns.
    std::vector<double>
    row_of_w(const Tensor<1, 2> &direction, const NodalWeights &weights)
    {
      std::vector<double> row = {direction[0], direction[1]};
      for (const auto &phi : weights.phi)
        for (unsigned int c = 0; c < 2; ++c)
          row.push_back(-phi[c] * direction[c]);
      return row;
    }

    std::vector<double>
    row_of_dw(const Tensor<1, 2> &direction, const NodalWeights &weights)
    {
      std::vector<double> row = {0., 0.};
      for (const auto &dphi : weights.dphi)
        for (unsigned int c = 0; c < 2; ++c)
          row.push_back(dphi[c] * direction[c]);
      return row;
    }
  } // namespace



  GapDerivatives
  differentiate_gap(const CurveProjection &projection,
                    const NodalWeights    &weights)
  {
    const unsigned int n = 2 * (1 + weights.nodes.size());
    const double       g = projection.gap;
    GapDerivatives     result;
    result.gap = row_of_w(projection.normal, weights);
    result.parameter.assign(n, 0.);
    result.hessian.reinit(n, n);
    const std::vector<double> along = row_of_w(projection.tangent, weights);
    if (projection.is_vertex)
      {
        for (unsigned int i = 0; i < n; ++i)
          for (unsigned int j = 0; j < n; ++j)
            result.hessian(i, j) = g == 0. ? 0. : along[i] * along[j] / g;
        return result;
      }

    const double square = projection.speed * projection.speed;
    const double D = std::max(square - g * projection.curvature, 1e-8 * square);
    const std::vector<double> turn = row_of_dw(projection.normal, weights);
    std::vector<double>      &dxi  = result.parameter;
    for (unsigned int i = 0; i < n; ++i)
      dxi[i] = (projection.speed * along[i] + g * turn[i]) / D;
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int j = 0; j < n; ++j)
        result.hessian(i, j) =
          (g * turn[i] * turn[j] - projection.curvature * D * dxi[i] * dxi[j] -
           D * (turn[i] * dxi[j] + dxi[i] * turn[j])) /
          square;
    return result;
  }
} // namespace Signorini
