#include "spatial_tangent.h"

#include <cmath>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    // Symmetric tensors as vectors in deal.II's order xx, yy, zz, xy, xz, yz.
    constexpr unsigned int row[6]         = {0, 1, 2, 0, 0, 1};
    constexpr unsigned int column[6]      = {0, 1, 2, 1, 2, 2};
    constexpr unsigned int position[3][3] = {{0, 3, 4}, {3, 1, 5}, {4, 5, 2}};

    // x / sinh(x). The series is exact to the digit up to 0.1.
    double
    over_sinh(const double x)
    {
      const double y = x * x;
      if (y > 0.01)
        return x / std::sinh(x);
      return 1. - y / 6. *
                    (1. - 7. * y / 60. *
                            (1. - 31. * y / 294. * (1. - 127. * y / 1240.)));
    }

    // How the frame moves with the rate of deformation d.
    struct FrameRates
    {
      explicit FrameRates(const PrincipalFrame &frame)
      {
        const auto &stretch = frame.stretch;
        for (unsigned int a = 0; a < 6; ++a)
          {
            const unsigned int i = row[a], j = column[a];
            strain[a] = over_sinh(frame.log_strain[i] - frame.log_strain[j]);
            carried[i][j] =
              i == j ? 1. : stretch[i] / (stretch[i] + stretch[j]);
            carried[j][i] = i == j ? 1. : 1. - carried[i][j];
          }
      }

      // d e_ab = Delta/sinh(Delta) d_ab
      double strain[6];

      // 1 + tanh(Delta/2), halved where two entries share d_ij.
      double carried[3][3];
    };

    // The components from first on, n of them. They must not mix with others:
    // either all six, or those within the plane, or those across it.
    //
    // The tangent in principal axes is the derivative of the law, less what the
    // axes carry along as they stretch and shear,
    //   sum_k A_ik M_kj + M_ik A_jk,  A_ij = (1 + tanh((e_i - e_j)/2)) d_ij.
    template <unsigned int first, unsigned int n>
    void
    principal_tangent(const FrameRates     &rates,
                      const StrainResponse &response,
                      double (&tangent)[n][n])
    {
      const auto &direction = response.direction;
      const auto &factor    = response.factor;
      for (unsigned int a = 0; a < n; ++a)
        for (unsigned int b = 0; b < n; ++b)
          {
            const unsigned int A = first + a, B = first + b;
            double             value = 0.;
            if (response.flows)
              value =
                direction.access_raw_entry(A) * factor.access_raw_entry(B) +
                factor.access_raw_entry(A) * direction.access_raw_entry(B);
            if (A < 3 && B < 3)
              value += response.bulk - 2. / 3. * response.shear;
            if (A == B)
              value += A < 3 ? 2. * response.shear : response.shear;
            tangent[a][b] = value * rates.strain[B];
          }
      for (unsigned int a = 0; a < n; ++a)
        {
          const unsigned int i = row[first + a], j = column[first + a];
          for (unsigned int k = 0; k < 3; ++k)
            {
              const unsigned int ik = position[i][k] - first;
              const unsigned int jk = position[j][k] - first;
              if (ik < n)
                tangent[a][ik] -= rates.carried[i][k] * response.stress[k][j];
              if (jk < n)
                tangent[a][jk] -= rates.carried[j][k] * response.stress[k][i];
            }
        }
      for (unsigned int a = 0; a < n; ++a)
        for (unsigned int b = 0; b < a; ++b)
          tangent[a][b] = tangent[b][a] = 0.5 * (tangent[a][b] + tangent[b][a]);
    }

    // Stress and tangent of these components in space.
    template <unsigned int first, unsigned int n>
    void
    push_forward(const Tensor<2, 3>    &axes,
                 const FrameRates      &rates,
                 const StrainResponse  &response,
                 SymmetricTensor<2, 3> &stress,
                 double (&tangent)[36])
    {
      double principal[n][n];
      principal_tangent<first, n>(rates, response, principal);

      // (axes T axes^T)_a = sum_b Q_ab T_b over tensors as vectors.
      double Q[n][n], half[n][n];
      for (unsigned int a = 0; a < n; ++a)
        for (unsigned int b = 0; b < n; ++b)
          {
            const unsigned int i = row[first + a], j = column[first + a];
            const unsigned int k = row[first + b], l = column[first + b];
            Q[a][b] = axes[i][k] * axes[j][l];
            if (k != l)
              Q[a][b] += axes[i][l] * axes[j][k];
            stress.access_raw_entry(first + a) +=
              Q[a][b] * response.stress.access_raw_entry(first + b);
          }
      for (unsigned int a = 0; a < n; ++a)
        for (unsigned int b = 0; b < n; ++b)
          {
            double sum = 0.;
            for (unsigned int c = 0; c < n; ++c)
              sum += Q[a][c] * principal[c][b];
            half[a][b] = sum;
          }
      for (unsigned int a = 0; a < n; ++a)
        for (unsigned int b = 0; b <= a; ++b)
          {
            double sum = 0.;
            for (unsigned int c = 0; c < n; ++c)
              sum += half[a][c] * Q[b][c];
            tangent[6 * (first + a) + first + b] = sum;
            tangent[6 * (first + b) + first + a] = sum;
          }
    }
  } // namespace



  MaterialResponse
  push_forward(const PrincipalFrame &frame, const StrainResponse &response)
  {
    const FrameRates      rates(frame);
    const Tensor<2, 3>   &axes = frame.spatial_axes;
    SymmetricTensor<2, 3> stress;
    // Not cleared before it is filled, which would take a tenth of the time.
    double tangent[36];
    if (frame.is_planar)
      {
        for (const unsigned int a : {4, 5})
          for (const unsigned int b : {0, 1, 2, 3})
            tangent[6 * a + b] = tangent[6 * b + a] = 0.;
        push_forward<0, 4>(axes, rates, response, stress, tangent);
        push_forward<4, 2>(axes, rates, response, stress, tangent);
      }
    else
      push_forward<0, 6>(axes, rates, response, stress, tangent);
    return {stress,
            SymmetricTensor<4, 3>(tangent),
            response.energy_density,
            response.state.plastic_work_density};
  }



  SymmetricTensor<2, 3>
  into_axes(const SymmetricTensor<2, 3> &tensor, const Tensor<2, 3> &axes)
  {
    return symmetrize(transpose(axes) * Tensor<2, 3>(tensor) * axes);
  }
} // namespace Signorini
