#ifndef signorini_tests_potential_h
#define signorini_tests_potential_h

#include <signorini/material/material.h>

#include <array>

#include <Sacado.hpp>

namespace Signorini
{
  template <typename Number>
  using Square = std::array<std::array<Number, 3>, 3>;

  template <typename Number, typename Other>
  Square<Number>
  product(const Square<Number> &a, const Square<Other> &b)
  {
    Square<Number> result;
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int j = 0; j < 3; ++j)
        result[i][j] =
          a[i][0] * b[0][j] + a[i][1] * b[1][j] + a[i][2] * b[2][j];
    return result;
  }

  template <typename Number>
  Number
  determinant_of(const Square<Number> &m)
  {
    return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
           m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
           m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
  }

  template <typename Number>
  Square<Number>
  inverse_of(const Square<Number> &m)
  {
    const Number   determinant = determinant_of(m);
    Square<Number> result;
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int j = 0; j < 3; ++j)
        {
          const unsigned int a = (i + 1) % 3, b = (i + 2) % 3;
          const unsigned int c = (j + 1) % 3, d = (j + 2) % 3;
          result[j][i] = (m[a][c] * m[b][d] - m[a][d] * m[b][c]) / determinant;
        }
    return result;
  }

  /** ln of a matrix C by its series 2 artanh((C - 1)(C + 1)^-1). */
  template <typename Number>
  Square<Number>
  logarithm(const Square<Number> &C)
  {
    Square<Number> minus = C, plus = C;
    for (unsigned int i = 0; i < 3; ++i)
      {
        minus[i][i] -= 1.;
        plus[i][i] += 1.;
      }
    const Square<Number> z      = product(minus, inverse_of(plus));
    const Square<Number> square = product(z, z);
    Square<Number>       power = z, sum = z;
    for (unsigned int k = 3; k < 100; k += 2)
      {
        power = product(power, square);
        for (unsigned int i = 0; i < 3; ++i)
          for (unsigned int j = 0; j < 3; ++j)
            sum[i][j] += power[i][j] / static_cast<double>(k);
      }
    for (auto &row : sum)
      for (auto &entry : row)
        entry *= 2.;
    return sum;
  }

  /**
   * The potential of a step of Hencky's elasticity with linear hardening: the
   * elastic energy of the trial strain, less what flow takes from it,
   *   K/2 (tr E)^2 + q^2/(6 G) - <q - sigma_y>^2 / (2 (3 G + H)).
   */
  struct HenckyPotential
  {
    double youngs_modulus;
    double poissons_ratio;
    double yield_stress      = 1e300; // at the start of the step
    double hardening_modulus = 0.;

    dealii::Tensor<2, 3> inverse_plastic =
      dealii::Tensor<2, 3>(dealii::unit_symmetric_tensor<3>());

    template <typename Number>
    Number
    operator()(const Square<Number> &F) const
    {
      const double   K = youngs_modulus / (3. * (1. - 2. * poissons_ratio));
      const double   G = youngs_modulus / (2. * (1. + poissons_ratio));
      Square<double> plastic;
      for (unsigned int i = 0; i < 3; ++i)
        for (unsigned int j = 0; j < 3; ++j)
          plastic[i][j] = inverse_plastic[i][j];
      const Square<Number> elastic = product(F, plastic);
      Square<Number>       transposed;
      for (unsigned int i = 0; i < 3; ++i)
        for (unsigned int j = 0; j < 3; ++j)
          transposed[i][j] = elastic[j][i];
      const Square<Number> twice = logarithm(product(transposed, elastic));
      const Number trace  = 0.5 * (twice[0][0] + twice[1][1] + twice[2][2]);
      Number       square = 0.; // of the deviator
      for (unsigned int i = 0; i < 3; ++i)
        for (unsigned int j = 0; j < 3; ++j)
          {
            Number entry = 0.5 * twice[i][j];
            if (i == j)
              entry -= trace / 3.;
            square += entry * entry;
          }
      Number       energy   = 0.5 * K * trace * trace + G * square;
      const Number q_square = 6. * G * G * square;
      if (q_square > yield_stress * yield_stress)
        {
          const Number beyond = sqrt(q_square) - yield_stress;
          energy -= beyond * beyond / (2. * (3. * G + hardening_modulus));
        }
      return energy;
    }
  };

  /** mu/2 (tr C - 3 - 2 ln J) + lambda/2 (ln J)^2. */
  struct NeoHookePotential
  {
    double youngs_modulus;
    double poissons_ratio;

    template <typename Number>
    Number
    operator()(const Square<Number> &F) const
    {
      const double mu = youngs_modulus / (2. * (1. + poissons_ratio));
      const double lambda =
        2. * mu * poissons_ratio / (1. - 2. * poissons_ratio);
      const Number log_J = log(determinant_of(F));
      Number       trace = 0.;
      for (const auto &row : F)
        for (const auto &entry : row)
          trace += entry * entry;
      return 0.5 * mu * (trace - 3. - 2. * log_J) +
             0.5 * lambda * log_J * log_J;
    }
  };

  /**
   * What a potential W(F) of the deformation gradient says:
   *   tau = P F^T, c_ijkl = d^2W/(dF_iJ dF_kL) F_jJ F_lL - delta_ik tau_jl.
   */
  template <typename Potential>
  MaterialResponse
  differentiate(const Potential            &potential,
                const dealii::Tensor<2, 3> &gradient)
  {
    // Second derivatives by differentiating the type twice.
    using Single = Sacado::Fad::SFad<double, 9>;
    using Double = Sacado::Fad::SFad<Single, 9>;

    Square<Double> F;
    for (unsigned int i = 0; i < 9; ++i)
      F[i / 3][i % 3] =
        Double(9, i, Single(9, i, gradient[i / 3][i % 3] + (i % 4 == 0)));
    const Double     W        = potential(F);
    MaterialResponse response = {{}, {}, W.val().val(), 0.};
    const auto       f = [&](const unsigned int i, const unsigned int j) {
      return gradient[i][j] + (i == j);
    };
    dealii::Tensor<2, 3> stress;
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int j = 0; j < 3; ++j)
        for (unsigned int J = 0; J < 3; ++J)
          stress[i][j] += W.dx(3 * i + J).val() * f(j, J);
    response.stress = symmetrize(stress);
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int j = i; j < 3; ++j)
        for (unsigned int k = 0; k < 3; ++k)
          for (unsigned int l = k; l < 3; ++l)
            {
              double sum = i == k ? -stress[j][l] : 0.;
              for (unsigned int J = 0; J < 3; ++J)
                for (unsigned int L = 0; L < 3; ++L)
                  sum += W.dx(3 * i + J).dx(3 * k + L) * f(j, J) * f(l, L);
              response.tangent[i][j][k][l] = sum;
            }
    return response;
  }
} // namespace Signorini

#endif
