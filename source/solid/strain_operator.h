#ifndef signorini_solid_strain_operator_h
#define signorini_solid_strain_operator_h

#include <signorini/solid/formulation.h>

#include <deal.II/base/tensor.h>
#include <deal.II/lac/full_matrix.h>

#include <array>
#include <vector>

namespace Signorini
{
  /**
   * B_a of one node: the reduced strains of formulation.h from the node's
   * displacement, n_strains x dim. 3 strains: plane, 4: with that across the
   * plane or around the axis, 6: solid.
   */
  template <int dim, int n_strains>
  using StrainOperator = std::array<std::array<double, dim>, n_strains>;

  /**
   * @param g       gradient of the shape function, 1/m
   * @param over_r  shape function over radius, 1/m, read when axisymmetric
   */
  template <int dim, int n_strains>
  StrainOperator<dim, n_strains>
  strain_operator(const dealii::Tensor<1, dim> &g, const double over_r)
  {
    if constexpr (n_strains == 3)
      return {{{{g[0], 0.}}, {{0., g[1]}}, {{g[1], g[0]}}}};
    else if constexpr (n_strains == 4)
      return {{{{g[0], 0.}}, {{0., g[1]}}, {{g[1], g[0]}}, {{over_r, 0.}}}};
    else
      return {{{{g[0], 0., 0.}},
               {{0., g[1], 0.}},
               {{0., 0., g[2]}},
               {{g[1], g[0], 0.}},
               {{0., g[2], g[1]}},
               {{g[2], 0., g[0]}}}};
  }

  /**
   * Adds weight B_a^T D B_b to the lower blocks (b <= a) of a cell matrix whose
   * unknowns are counted node by node, component by component.
   */
  template <int dim, int n_strains>
  void
  add_lower_blocks(const std::vector<StrainOperator<dim, n_strains>> &B,
                   const ReducedTangent                              &D,
                   const double                                       weight,
                   dealii::FullMatrix<double> &cell_matrix)
  {
    for (unsigned int b = 0; b < B.size(); ++b)
      {
        StrainOperator<dim, n_strains> DB;
        for (unsigned int s = 0; s < n_strains; ++s)
          for (unsigned int j = 0; j < dim; ++j)
            {
              double sum = 0.;
              for (unsigned int t = 0; t < n_strains; ++t)
                sum += D[s][t] * B[b][t][j];
              DB[s][j] = weight * sum;
            }
        for (unsigned int a = b; a < B.size(); ++a)
          for (unsigned int i = 0; i < dim; ++i)
            for (unsigned int j = 0; j < dim; ++j)
              {
                double sum = 0.;
                for (unsigned int s = 0; s < n_strains; ++s)
                  sum += B[a][s][i] * DB[s][j];
                cell_matrix(a * dim + i, b * dim + j) += sum;
              }
      }
  }
} // namespace Signorini

#endif
