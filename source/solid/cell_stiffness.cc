// The part of CellResponse that is its derivative.
#include "cell_response.h"
#include "spatial_stress.h"

namespace Signorini
{
  using namespace dealii;

  template <int dim, int n_strains>
  void
  CellResponse<dim, n_strains>::add_stiffness()
  {
    for (unsigned int q = 0; q < points_.size(); ++q)
      {
        set_strain_operators(points_[q]);
        add_lower_blocks<dim, n_strains>(strain_operators_,
                                         responses_[q].tangent,
                                         points_[q].volume,
                                         stiffness);
        if (is_finite_)
          add_geometric_stiffness(points_[q], responses_[q]);
        if (is_finite_ && has_mean_dilatation_)
          add_dilatation_stiffness(points_[q], responses_[q]);
      }
    if (is_finite_ && has_mean_dilatation_)
      add_mean_divergence_stiffness();
    mirror_lower_blocks();
  }



  template <int dim, int n_strains>
  void
  CellResponse<dim, n_strains>::mirror_lower_blocks()
  {
    for (unsigned int i = 0; i < stiffness.m(); ++i)
      for (unsigned int j = i + 1; j < stiffness.n(); ++j)
        stiffness(i, j) = stiffness(j, i);
  }



  template <int dim, int n_strains>
  void
  CellResponse<dim, n_strains>::add_geometric_stiffness(
    const DeformedPoint &kinematics,
    const PointResponse &response)
  {
    // grad N_a . stress grad N_b, for each component; and the hoop's share.
    const SpatialStress<dim, n_strains> stress(response.stress);
    const auto                         &g = kinematics.shape_gradients;
    for (unsigned int b = 0; b < g.size(); ++b)
      {
        const Tensor<1, dim> traction =
          kinematics.volume * (stress.between * g[b]);
        for (unsigned int a = b; a < g.size(); ++a)
          {
            const double entry = g[a] * traction;
            for (unsigned int c = 0; c < dim; ++c)
              stiffness(a * dim + c, b * dim + c) += entry;
            if (is_axisymmetric_)
              stiffness(a * dim, b * dim) += kinematics.volume * stress.across *
                                             kinematics.over_r[a] *
                                             kinematics.over_r[b];
          }
      }
  }



  template <int dim, int n_strains>
  void
  CellResponse<dim, n_strains>::add_dilatation_stiffness(
    const DeformedPoint &kinematics,
    const PointResponse &response)
  {
    // With l = grad du, L = grad Du, alpha = (mean div - div)/3 of du, beta
    // that of Du, p = tr(stress)/3:
    //   2 alpha stress:L + 2 beta stress:l + 6 alpha beta p + p tr(l L).
    const SpatialStress<dim, n_strains> stress(response.stress);
    const double p      = (trace(stress.between) + stress.across) / 3.;
    const auto  &g      = kinematics.shape_gradients;
    const auto  &over_r = kinematics.over_r;
    const auto   alpha  = [&](const unsigned int a, const unsigned int c) {
      return (kinematics.mean_divergence[a][c] - kinematics.divergence[a][c]) /
             3.;
    };
    for (unsigned int b = 0; b < g.size(); ++b)
      {
        const Tensor<1, dim> power_b = stress.power(g[b], over_r[b]);
        for (unsigned int a = b; a < g.size(); ++a)
          {
            const Tensor<1, dim> power_a = stress.power(g[a], over_r[a]);
            for (unsigned int i = 0; i < dim; ++i)
              for (unsigned int j = 0; j < dim; ++j)
                {
                  const double product =
                    trace_of_product(g[a], over_r[a], i, g[b], over_r[b], j);
                  stiffness(a * dim + i, b * dim + j) +=
                    kinematics.volume *
                    (2. * alpha(a, i) * power_b[j] +
                     2. * power_a[i] * alpha(b, j) +
                     6. * p * alpha(a, i) * alpha(b, j) + p * product);
                }
          }
      }
  }



  template <int dim, int n_strains>
  void
  CellResponse<dim, n_strains>::add_mean_divergence_stiffness()
  {
    // int p (second derivative of ln theta) dV, with P the projection:
    //   int p/theta P[J (div div - tr(l L))] - p (mean div)(mean div) dV.
    for (unsigned int r = 0; r < points_.size(); ++r)
      {
        const DeformedPoint &kinematics = points_[r];
        const auto          &g          = kinematics.shape_gradients;
        const auto          &over_r     = kinematics.over_r;
        const auto          &divergence = kinematics.divergence;
        const auto          &mean       = kinematics.mean_divergence;
        for (unsigned int b = 0; b < g.size(); ++b)
          for (unsigned int a = b; a < g.size(); ++a)
            for (unsigned int i = 0; i < dim; ++i)
              for (unsigned int j = 0; j < dim; ++j)
                {
                  const double product =
                    trace_of_product(g[a], over_r[a], i, g[b], over_r[b], j);
                  stiffness(a * dim + i, b * dim + j) +=
                    weights_[r] *
                      (divergence[a][i] * divergence[b][j] - product) -
                    pressures_[r] * mean[a][i] * mean[b][j];
                }
      }
  }



#define INSTANTIATE(dim, n_strains)                            \
  template void CellResponse<dim, n_strains>::add_stiffness(); \
  template void CellResponse<dim, n_strains>::mirror_lower_blocks();
  INSTANTIATE(2, 3)
  INSTANTIATE(2, 4)
  INSTANTIATE(3, 6)
#undef INSTANTIATE
} // namespace Signorini
