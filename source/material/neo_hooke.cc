#include <signorini/material/neo_hooke.h>

#include <cmath>

#include "volume_ratio.h"

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    // x - ln(1 + x) >= 0. With s = x/(2 + x), ln(1 + x) = 2 artanh(s): what is
    // left of the difference for small x is the series of artanh(s) - s.
    double
    excess_over_log(const double x)
    {
      if (std::abs(x) > 0.05)
        return x - std::log1p(x);
      const double s = x / (2. + x), t = s * s;
      const double series =
        1. / 3. + t * (1. / 5. + t * (1. / 7. + t * (1. / 9. + t / 11.)));
      return x * s - 2. * s * t * series;
    }
  } // namespace



  NeoHooke::NeoHooke(const ElasticConstants &constants, const double density)
    : Material(Kinematics::finite_strain, density)
    , constants_(constants)
  {}



  MaterialResponse
  NeoHooke::respond(const MaterialPoint &point,
                    const ArrayView<double> /*history*/) const
  {
    const double        mu     = constants_.shear;
    const double        lambda = constants_.lame();
    const Tensor<2, 3> &H      = point.gradient;
    // J - 1 = tr H + (tr H)^2/2 - tr(H H)/2 + det H
    const double volume_change = volume_ratio_minus_one(H);
    const double log_J         = std::log1p(volume_change);

    SymmetricTensor<2, 3> stress;
    double                square = 0., product = 0.; // H:H, tr(H H)
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int j = 0; j < 3; ++j)
        {
          square += H[i][j] * H[i][j];
          product += H[i][j] * H[j][i];
          if (j >= i)
            stress[i][j] = mu * (H[i][j] + H[j][i] + H[i] * H[j]);
        }
    double       entries[36] = {};
    const double twice       = 2. * (mu - lambda * log_J);
    for (unsigned int i = 0; i < 3; ++i)
      {
        stress[i][i] += lambda * log_J;
        for (unsigned int j = 0; j < 3; ++j)
          entries[6 * i + j] = lambda;
        entries[7 * i] += twice;
        entries[7 * (i + 3)] = 0.5 * twice;
      }

    // tr C - 3 - 2 ln J = 2 tr H + H:H - 2 ln J, with tr H from J - 1, so that
    // no terms of first order are left to cancel.
    const double first_order = trace(H);
    const double shape       = square + product - first_order * first_order -
                         2. * determinant(H) +
                         2. * excess_over_log(volume_change);
    return {stress,
            SymmetricTensor<4, 3>(entries),
            0.5 * mu * shape + 0.5 * lambda * log_J * log_J,
            0.};
  }
} // namespace Signorini
