#include "cell_response.h"

#include <cmath>

#include "spatial_stress.h"

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    // Rows of the reduced strains that are not shear.
    template <int n_strains>
    constexpr std::array<unsigned int, n_strains == 3 ? 2 : 3>
    normal_rows()
    {
      if constexpr (n_strains == 3)
        return {{0, 1}};
      else if constexpr (n_strains == 4)
        return {{0, 1, 3}};
      else
        return {{0, 1, 2}};
    }

    // det(1 + H) - 1 without the loss of digits by 1 + H.
    double
    volume_change(const Tensor<2, 2> &H, const double thickness_strain)
    {
      const double area = trace(H) + determinant(H);
      return area + thickness_strain + area * thickness_strain;
    }

    double
    volume_change(const Tensor<2, 3> &H, const double /*thickness_strain*/)
    {
      const double first = trace(H);
      return first + 0.5 * (first * first - trace(H * H)) + determinant(H);
    }

    [[noreturn]] void
    throw_inside_out(const double volume_change)
    {
      throw MaterialFailure("the cell is turned inside out: its volume is " +
                            std::to_string(1. + volume_change) +
                            " times that at the start");
    }
  } // namespace



  template <int dim, int n_strains>
  CellResponse<dim, n_strains>::CellResponse(const Body<dim>   &body,
                                             const unsigned int n_points)
    : stiffness(body.fe().n_dofs_per_cell(), body.fe().n_dofs_per_cell())
    , force(body.fe().n_dofs_per_cell())
    , stored_energy(0.)
    , plastic_work(0.)
    , stresses(n_points)
    , body_(&body)
    , is_finite_(body.kinematics() == Kinematics::finite_strain)
    , is_axisymmetric_(body.formulation() == Formulation::axisymmetric)
    , has_mean_dilatation_(body.has_mean_dilatation())
    , points_(n_points)
    , strain_operators_(body.scalar_fe().n_dofs_per_cell())
    , projection_(body.scalar_fe().degree, n_points)
    , volumes_(n_points)
    , pressures_(n_points)
  {
    for (DeformedPoint &point : points_)
      {
        point.shape_gradients.resize(body.scalar_fe().n_dofs_per_cell());
        point.over_r.resize(body.scalar_fe().n_dofs_per_cell());
        point.mean_divergence.resize(body.scalar_fe().n_dofs_per_cell());
      }
  }



  template <int dim, int n_strains>
  void
  CellResponse<dim, n_strains>::evaluate(
    const FEValues<dim>       &values,
    const std::vector<double> &displacement,
    const Point               &point,
    const bool                 with_stiffness)
  {
    stiffness     = 0.;
    force         = 0.;
    stored_energy = plastic_work = 0.;
    for (const unsigned int q : values.quadrature_point_indices())
      find_kinematics(values, displacement, q);
    if (has_mean_dilatation_)
      find_means(values);

    PointResponse response;
    for (const unsigned int q : values.quadrature_point_indices())
      {
        const DeformedPoint &kinematics = points_[q];
        set_strain_operators(kinematics);
        if (point.constant)
          {
            add_lower_blocks<dim, n_strains>(strain_operators_,
                                             point.constant->tangent,
                                             kinematics.volume,
                                             stiffness);
            continue;
          }
        Tensor<2, dim> gradient         = kinematics.gradient;
        double         thickness_strain = kinematics.hoop;
        if (has_mean_dilatation_)
          set_mean_dilatation(kinematics, gradient, thickness_strain);
        const unsigned int n = point.n_history_values;
        response =
          respond(body_->formulation(),
                  *point.material,
                  gradient,
                  thickness_strain,
                  point.step_size,
                  make_array_view(point.history_n.begin() + q * n,
                                  point.history_n.begin() + (q + 1) * n),
                  make_array_view(point.history.begin() + q * n,
                                  point.history.begin() + (q + 1) * n));
        stresses[q] = response.cauchy_stress;
        stored_energy += kinematics.volume * response.energy_density;
        plastic_work += kinematics.volume * response.plastic_work_density;
        add_force(response, kinematics.volume);
        if (!with_stiffness)
          continue;
        add_lower_blocks<dim, n_strains>(strain_operators_,
                                         response.tangent,
                                         kinematics.volume,
                                         stiffness);
        if (is_finite_)
          add_geometric_stiffness(kinematics, response);
        if (is_finite_ && has_mean_dilatation_)
          add_dilatation_stiffness(q, response);
      }
    if (with_stiffness && is_finite_ && has_mean_dilatation_ && !point.constant)
      add_mean_divergence_stiffness();
    for (unsigned int i = 0; i < stiffness.m(); ++i)
      for (unsigned int j = i + 1; j < stiffness.n(); ++j)
        stiffness(i, j) = stiffness(j, i);
    if (point.constant)
      {
        for (unsigned int i = 0; i < force.size(); ++i)
          for (unsigned int j = 0; j < force.size(); ++j)
            force[i] += stiffness(i, j) * displacement[j];
        for (unsigned int i = 0; i < force.size(); ++i)
          stored_energy += 0.5 * force[i] * displacement[i];
      }
  }



  template <int dim, int n_strains>
  void
  CellResponse<dim, n_strains>::find_kinematics(
    const FEValues<dim>       &values,
    const std::vector<double> &displacement,
    const unsigned int         q)
  {
    DeformedPoint &kinematics = points_[q];
    const auto    &point      = values.quadrature_point(q);
    kinematics.gradient       = 0.;
    kinematics.hoop           = 0.;
    kinematics.volume         = values.JxW(q) * body_->volume_factor(point);
    for (const unsigned int a : values.dof_indices())
      {
        kinematics.shape_gradients[a] = values.shape_grad(a, q);
        kinematics.over_r[a] =
          is_axisymmetric_ ? values.shape_value(a, q) / point[0] : 0.;
        for (unsigned int c = 0; c < dim; ++c)
          kinematics.gradient[c] +=
            displacement[a * dim + c] * kinematics.shape_gradients[a];
        kinematics.hoop += kinematics.over_r[a] * displacement[a * dim];
      }
    if (!is_finite_)
      {
        kinematics.dilatation = trace(kinematics.gradient) + kinematics.hoop;
        return;
      }

    Tensor<2, dim> F = kinematics.gradient;
    for (unsigned int i = 0; i < dim; ++i)
      F[i][i] += 1.;
    kinematics.dilatation = volume_change(kinematics.gradient, kinematics.hoop);
    if (!(kinematics.dilatation > -1.) || !(kinematics.hoop > -1.))
      throw_inside_out(kinematics.dilatation);
    const Tensor<2, dim> to_space = transpose(invert(F));
    for (const unsigned int a : values.dof_indices())
      {
        kinematics.shape_gradients[a] =
          to_space * kinematics.shape_gradients[a];
        kinematics.over_r[a] /= 1. + kinematics.hoop;
      }
  }



  template <int dim, int n_strains>
  void
  CellResponse<dim, n_strains>::find_means(const FEValues<dim> &values)
  {
    for (unsigned int q = 0; q < points_.size(); ++q)
      volumes_[q] = points_[q].volume;
    projection_.reinit(values, volumes_);
    for (unsigned int q = 0; q < points_.size(); ++q)
      {
        DeformedPoint &at  = points_[q];
        at.mean_dilatation = 0.;
        for (unsigned int r = 0; r < points_.size(); ++r)
          at.mean_dilatation += projection_(q, r) * points_[r].dilatation;
        if (is_finite_ && !(at.mean_dilatation > -1.))
          throw_inside_out(at.mean_dilatation);
        std::fill(at.mean_divergence.begin(),
                  at.mean_divergence.end(),
                  Tensor<1, dim>());
        for (unsigned int r = 0; r < points_.size(); ++r)
          {
            const DeformedPoint &of = points_[r];
            const double         weight =
              projection_(q, r) * volume_ratio(of) / mean_volume_ratio(at);
            for (unsigned int a = 0; a < at.mean_divergence.size(); ++a)
              for (unsigned int c = 0; c < dim; ++c)
                at.mean_divergence[a][c] += weight * divergence(of, a, c);
          }
      }
  }



  template <int dim, int n_strains>
  void
  CellResponse<dim, n_strains>::set_mean_dilatation(
    const DeformedPoint &kinematics,
    Tensor<2, dim>      &gradient,
    double              &thickness_strain) const
  {
    // H_bar = s H + (s - 1) 1 with s = (theta / J)^(1/3).
    double s_minus_one =
      (kinematics.mean_dilatation - kinematics.dilatation) / 3.;
    if (is_finite_)
      {
        s_minus_one = std::expm1((std::log1p(kinematics.mean_dilatation) -
                                  std::log1p(kinematics.dilatation)) /
                                 3.);
        gradient *= 1. + s_minus_one;
        thickness_strain *= 1. + s_minus_one;
      }
    for (unsigned int i = 0; i < dim; ++i)
      gradient[i][i] += s_minus_one;
    thickness_strain += s_minus_one;
  }



  template <int dim, int n_strains>
  void
  CellResponse<dim, n_strains>::set_strain_operators(
    const DeformedPoint &kinematics)
  {
    for (unsigned int a = 0; a < strain_operators_.size(); ++a)
      {
        Operator &B = strain_operators_[a];
        B = strain_operator<dim, n_strains>(kinematics.shape_gradients[a],
                                            kinematics.over_r[a]);
        if (has_mean_dilatation_)
          for (unsigned int c = 0; c < dim; ++c)
            {
              const double shift = (kinematics.mean_divergence[a][c] -
                                    divergence(kinematics, a, c)) /
                                   3.;
              for (const unsigned int row : normal_rows<n_strains>())
                B[row][c] += shift;
            }
      }
  }



  template <int dim, int n_strains>
  void
  CellResponse<dim, n_strains>::add_force(const PointResponse &response,
                                          const double         volume)
  {
    for (unsigned int a = 0; a < strain_operators_.size(); ++a)
      for (unsigned int c = 0; c < dim; ++c)
        {
          double sum = 0.;
          for (unsigned int s = 0; s < n_strains; ++s)
            sum += strain_operators_[a][s][c] * response.stress[s];
          force[a * dim + c] += volume * sum;
        }
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
    const unsigned int   q,
    const PointResponse &response)
  {
    // With l = grad du, L = grad Du, alpha = (mean div - div)/3 of du, beta
    // that of Du, p = tr(stress)/3:
    //   2 alpha stress:L + 2 beta stress:l + 6 alpha beta p + p tr(l L).
    const SpatialStress<dim, n_strains> stress(response.stress);
    const double         p = (trace(stress.between) + stress.across) / 3.;
    const DeformedPoint &kinematics = points_[q];
    pressures_[q]                   = kinematics.volume * p;

    const auto &g      = kinematics.shape_gradients;
    const auto &over_r = kinematics.over_r;
    const auto  alpha  = [&](const unsigned int a, const unsigned int c) {
      return (kinematics.mean_divergence[a][c] - divergence(kinematics, a, c)) /
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
        const auto          &mean       = kinematics.mean_divergence;
        double               weight     = 0.;
        for (unsigned int q = 0; q < points_.size(); ++q)
          weight += pressures_[q] / mean_volume_ratio(points_[q]) *
                    projection_(q, r) * volume_ratio(kinematics);
        for (unsigned int b = 0; b < g.size(); ++b)
          for (unsigned int a = b; a < g.size(); ++a)
            for (unsigned int i = 0; i < dim; ++i)
              for (unsigned int j = 0; j < dim; ++j)
                {
                  const double product =
                    trace_of_product(g[a], over_r[a], i, g[b], over_r[b], j);
                  stiffness(a * dim + i, b * dim + j) +=
                    weight * (divergence(kinematics, a, i) *
                                divergence(kinematics, b, j) -
                              product) -
                    pressures_[r] * mean[a][i] * mean[b][j];
                }
      }
  }



  template class CellResponse<2, 3>;
  template class CellResponse<2, 4>;
  template class CellResponse<3, 6>;
} // namespace Signorini
