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
    , mean_force(body.fe().n_dofs_per_cell())
    , stored_energy(0.)
    , plastic_work(0.)
    , heating(0.)
    , stresses(n_points)
    , body_(&body)
    , is_finite_(body.kinematics() == Kinematics::finite_strain)
    , is_axisymmetric_(body.formulation() == Formulation::axisymmetric)
    , has_mean_dilatation_(body.has_mean_dilatation())
    , is_mean_(false)
    , points_(n_points)
    , responses_(n_points)
    , start_(n_points)
    , means_(n_points)
    , strain_operators_(body.scalar_fe().n_dofs_per_cell())
    , projection_(body.scalar_fe().degree, n_points)
    , volumes_(n_points)
    , pressures_(n_points)
    , weights_(n_points)
  {
    for (DeformedPoint &point : points_)
      {
        point.shape_gradients.resize(body.scalar_fe().n_dofs_per_cell());
        point.over_r.resize(body.scalar_fe().n_dofs_per_cell());
        point.divergence.resize(body.scalar_fe().n_dofs_per_cell());
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
    find_responses(values, displacement, point);
    if (point.constant)
      {
        set_constant_response(displacement, point);
        return;
      }
    find_divergences();
    add_forces();
    stiffness = 0.;
    if (with_stiffness)
      add_stiffness();
  }



  template <int dim, int n_strains>
  void
  CellResponse<dim, n_strains>::find_responses(
    const FEValues<dim>       &values,
    const std::vector<double> &displacement,
    const Point               &point)
  {
    for (const unsigned int q : values.quadrature_point_indices())
      find_kinematics(values, displacement, q);
    respond_to_kinematics(values, point);
  }



  template <int dim, int n_strains>
  void
  CellResponse<dim, n_strains>::respond_to_kinematics(
    const FEValues<dim> &values,
    const Point         &point)
  {
    stored_energy = plastic_work = heating = 0.;
    if (has_mean_dilatation_)
      find_means(values);
    if (point.constant)
      return;
    const unsigned int n = point.n_history_values;
    for (const unsigned int q : values.quadrature_point_indices())
      {
        const DeformedPoint &kinematics       = points_[q];
        Tensor<2, dim>       gradient         = kinematics.gradient;
        double               thickness_strain = kinematics.hoop;
        if (has_mean_dilatation_)
          set_mean_dilatation(kinematics, gradient, thickness_strain);
        MaterialStep step = point.step;
        if (!point.temperatures.empty())
          step.temperature = point.temperatures[q];
        responses_[q] =
          respond(body_->formulation(),
                  *point.material,
                  gradient,
                  thickness_strain,
                  step,
                  make_array_view(point.history_n.begin() + q * n,
                                  point.history_n.begin() + (q + 1) * n),
                  make_array_view(point.history.begin() + q * n,
                                  point.history.begin() + (q + 1) * n));
        stresses[q] = responses_[q].cauchy_stress;
        stored_energy += kinematics.volume * responses_[q].energy_density;
        plastic_work += kinematics.volume * responses_[q].plastic_work_density;
        heating += kinematics.volume * responses_[q].heating_density;
      }
    if (has_mean_dilatation_)
      find_pressures();
  }



  template <int dim, int n_strains>
  void
  CellResponse<dim, n_strains>::set_constant_response(
    const std::vector<double> &displacement,
    const Point               &point)
  {
    find_divergences();
    stiffness = 0.;
    for (const DeformedPoint &kinematics : points_)
      {
        set_strain_operators(kinematics);
        add_lower_blocks<dim, n_strains>(strain_operators_,
                                         point.constant->tangent,
                                         kinematics.volume,
                                         stiffness);
      }
    mirror_lower_blocks();
    force = 0.;
    for (unsigned int i = 0; i < force.size(); ++i)
      for (unsigned int j = 0; j < force.size(); ++j)
        force[i] += stiffness(i, j) * displacement[j];
    for (unsigned int i = 0; i < force.size(); ++i)
      stored_energy += 0.5 * force[i] * displacement[i];
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
    for (const unsigned int a : values.dof_indices())
      {
        for (unsigned int c = 0; c < dim; ++c)
          kinematics.gradient[c] +=
            displacement[a * dim + c] * values.shape_grad(a, q);
        if (is_axisymmetric_)
          kinematics.hoop +=
            values.shape_value(a, q) / point[0] * displacement[a * dim];
      }
    set_kinematics(values, q);
  }



  template <int dim, int n_strains>
  void
  CellResponse<dim, n_strains>::set_kinematics(const FEValues<dim> &values,
                                               const unsigned int   q)
  {
    DeformedPoint &kinematics = points_[q];
    const auto    &point      = values.quadrature_point(q);
    kinematics.turn           = unit_symmetric_tensor<dim>();
    kinematics.hoop_turn      = 1.;
    kinematics.volume         = values.JxW(q) * body_->volume_factor(point);
    for (const unsigned int a : values.dof_indices())
      {
        kinematics.shape_gradients[a] = values.shape_grad(a, q);
        kinematics.over_r[a] =
          is_axisymmetric_ ? values.shape_value(a, q) / point[0] : 0.;
      }
    if (!is_finite_)
      {
        kinematics.dilatation = trace(kinematics.gradient) + kinematics.hoop;
        return;
      }

    kinematics.dilatation = volume_change(kinematics.gradient, kinematics.hoop);
    if (!(kinematics.dilatation > -1.) || !(kinematics.hoop > -1.))
      throw_inside_out(kinematics.dilatation);
    const Tensor<2, dim> to_space =
      transpose(invert(deformation_gradient(kinematics.gradient)));
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
      }
  }



  template <int dim, int n_strains>
  void
  CellResponse<dim, n_strains>::find_pressures()
  {
    for (unsigned int q = 0; q < points_.size(); ++q)
      {
        const SpatialStress<dim, n_strains> stress(responses_[q].stress);
        pressures_[q] =
          points_[q].volume * (trace(stress.between) + stress.across) / 3.;
      }
    for (unsigned int r = 0; r < points_.size(); ++r)
      {
        weights_[r] = 0.;
        for (unsigned int q = 0; q < points_.size(); ++q)
          weights_[r] += pressures_[q] / mean_volume_ratio(points_[q]) *
                         projection_(q, r) * volume_ratio(points_[r]);
      }
  }



  template <int dim, int n_strains>
  void
  CellResponse<dim, n_strains>::find_divergences()
  {
    if (!has_mean_dilatation_)
      return;
    for (DeformedPoint &of : points_)
      for (unsigned int a = 0; a < of.divergence.size(); ++a)
        {
          of.divergence[a] = of.turn * of.shape_gradients[a];
          of.divergence[a][0] += of.hoop_turn * of.over_r[a];
        }
    for (unsigned int q = 0; q < points_.size(); ++q)
      {
        DeformedPoint &at = points_[q];
        std::fill(at.mean_divergence.begin(),
                  at.mean_divergence.end(),
                  Tensor<1, dim>());
        for (unsigned int r = 0; r < points_.size(); ++r)
          {
            const DeformedPoint &of = points_[r];
            const double         weight =
              projection_(q, r) * volume_ratio(of) / mean_volume_ratio(at);
            for (unsigned int a = 0; a < at.mean_divergence.size(); ++a)
              at.mean_divergence[a] += weight * of.divergence[a];
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
        if (is_mean_)
          turn(kinematics, B);
        if (has_mean_dilatation_)
          for (unsigned int c = 0; c < dim; ++c)
            {
              const double shift = (kinematics.mean_divergence[a][c] -
                                    kinematics.divergence[a][c]) /
                                   3.;
              for (const unsigned int row : normal_rows<n_strains>())
                B[row][c] += shift;
            }
      }
  }



  template <int dim, int n_strains>
  void
  CellResponse<dim, n_strains>::turn(const DeformedPoint &kinematics,
                                     Operator            &B) const
  {
    constexpr bool has_across = dim == 2 && n_strains == 4;
    for (unsigned int row = 0; row < n_strains - has_across; ++row)
      {
        Tensor<1, dim> entries;
        for (unsigned int c = 0; c < dim; ++c)
          entries[c] = B[row][c];
        entries = kinematics.turn * entries;
        for (unsigned int c = 0; c < dim; ++c)
          B[row][c] = entries[c];
      }
    if constexpr (has_across)
      B[3][0] *= kinematics.hoop_turn;
  }



  template <int dim, int n_strains>
  void
  CellResponse<dim, n_strains>::add_forces()
  {
    force = 0.;
    for (unsigned int q = 0; q < points_.size(); ++q)
      {
        set_strain_operators(points_[q]);
        for (unsigned int a = 0; a < strain_operators_.size(); ++a)
          for (unsigned int c = 0; c < dim; ++c)
            {
              double sum = 0.;
              for (unsigned int s = 0; s < n_strains; ++s)
                sum += strain_operators_[a][s][c] * responses_[q].stress[s];
              force[a * dim + c] += points_[q].volume * sum;
            }
      }
  }



  template <int dim, int n_strains>
  Tensor<2, dim>
  CellResponse<dim, n_strains>::deformation_gradient(
    const Tensor<2, dim> &gradient) const
  {
    Tensor<2, dim> F(unit_symmetric_tensor<dim>());
    if (is_finite_)
      F += gradient;
    return F;
  }



  template class CellResponse<2, 3>;
  template class CellResponse<2, 4>;
  template class CellResponse<3, 6>;
} // namespace Signorini
