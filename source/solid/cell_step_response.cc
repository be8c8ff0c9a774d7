// The part of CellResponse that answers to a step as a whole.
#include <cmath>
#include <limits>

#include "cell_response.h"

namespace Signorini
{
  using namespace dealii;

  template <int dim, int n_strains>
  void
  CellResponse<dim, n_strains>::evaluate_step(
    const FEValues<dim>       &values,
    const std::vector<double> &displacement_n,
    const std::vector<double> &displacement,
    const Point               &point,
    const bool                 with_stiffness)
  {
    if (point.constant)
      {
        std::vector<double> mean(displacement);
        for (unsigned int i = 0; i < mean.size(); ++i)
          mean[i] = 0.5 * (displacement_n[i] + displacement[i]);
        evaluate(values, mean, point, with_stiffness);
        mean_force = force;
        evaluate(values, displacement, point, with_stiffness);
        return;
      }
    unused_history_.resize(point.history_n.size());
    const Point at_start = {point.material,
                            nullptr,
                            {}, // at rest
                            {},
                            point.history_n,
                            make_array_view(unused_history_),
                            point.n_history_values};
    find_responses(values, displacement_n, at_start);
    keep_start();
    const double stored_energy_n = stored_energy;
    const double plastic_work_n  = plastic_work;

    Point at_middle     = at_start;
    at_middle.step.size = 0.5 * point.step.size;
    for (unsigned int q = 0; q < points_.size(); ++q)
      {
        find_kinematics(values, displacement, q);
        set_middle_kinematics(values, q);
      }
    respond_to_kinematics(values, at_middle);
    for (unsigned int q = 0; q < points_.size(); ++q)
      means_[q].middle_stress = pull_back(work_stress(q), points_[q]);

    evaluate(values, displacement, point, false);
    set_means();
    set_mean_force(values,
                   plastic_work == plastic_work_n ?
                     missing_work(stored_energy - stored_energy_n) :
                     0.);
    if (!with_stiffness)
      return;
    is_mean_ = true;
    set_mean_tangent();
    find_divergences();
    add_stiffness();
    is_mean_ = false;
  }



  template <int dim, int n_strains>
  void
  CellResponse<dim, n_strains>::set_middle_kinematics(
    const FEValues<dim> &values,
    const unsigned int   q)
  {
    // F between both ends whose strain is the mean of theirs. The mean of both
    // F has less where they turn.
    constexpr unsigned int n_corrections = 3;
    const StartPoint      &start         = start_[q];
    DeformedPoint         &at            = points_[q];
    const Tensor<2, dim>   F_n           = deformation_gradient(start.gradient);
    const Tensor<2, dim>   F_np          = deformation_gradient(at.gradient);
    Tensor<2, dim>         gradient      = 0.5 * (start.gradient + at.gradient);
    if (is_finite_)
      for (unsigned int i = 0; i < n_corrections; ++i)
        {
          const Tensor<2, dim> F = deformation_gradient(gradient);
          const Tensor<2, dim> lack =
            0.5 * (transpose(F_n) * F_n + transpose(F_np) * F_np) -
            transpose(F) * F;
          gradient += 0.5 * transpose(invert(F)) * lack;
        }
    const double hoop = is_finite_ && is_axisymmetric_ ?
                          std::sqrt(0.5 * (std::pow(1. + start.hoop, 2) +
                                           std::pow(1. + at.hoop, 2))) -
                            1. :
                          0.5 * (start.hoop + at.hoop);
    at.gradient       = gradient;
    at.hoop           = hoop;
    set_kinematics(values, q);
  }



  template <int dim, int n_strains>
  double
  CellResponse<dim, n_strains>::missing_work(
    const double change_of_energy) const
  {
    constexpr double short_square = 1e-4; // of a change of strain
    constexpr double rounding     = 8. * std::numeric_limits<double>::epsilon();
    double           volume = 0., terms = 0.;
    for (unsigned int q = 0; q < points_.size(); ++q)
      {
        volume += points_[q].volume;
        terms += points_[q].volume * responses_[q].tangent[0][0];
      }
    // Over a short step Simpson's rule is as good as the difference of the
    // energies, or better: they are rounded as the moduli are.
    const double work = work_of(&MeanPoint::stress);
    if (work_of(&MeanPoint::strain_change) < short_square * volume)
      return 2. / 3. * (work_of(&MeanPoint::middle_stress) - work);
    const double missing = change_of_energy - work;
    return std::abs(missing) > rounding * terms ? missing : 0.;
  }



  template <int dim, int n_strains>
  void
  CellResponse<dim, n_strains>::keep_start()
  {
    for (unsigned int q = 0; q < points_.size(); ++q)
      {
        const DeformedPoint &at = points_[q];
        start_[q].gradient      = at.gradient;
        start_[q].hoop          = at.hoop;
        start_[q].stress =
          pull_back(SpatialStress<dim, n_strains>(responses_[q].stress), at);
        start_[q].work_stress = pull_back(work_stress(q), at);
      }
  }



  template <int dim, int n_strains>
  SpatialStress<dim, n_strains>
  CellResponse<dim, n_strains>::work_stress(const unsigned int q) const
  {
    SpatialStress<dim, n_strains> stress(responses_[q].stress);
    if (!has_mean_dilatation_)
      return stress;
    const double change = (weights_[q] - pressures_[q]) / points_[q].volume;
    for (unsigned int i = 0; i < dim; ++i)
      stress.between[i][i] += change;
    stress.across += change;
    return stress;
  }



  template <int dim, int n_strains>
  typename CellResponse<dim, n_strains>::ReferenceTensor
  CellResponse<dim, n_strains>::pull_back(
    const SpatialStress<dim, n_strains> &stress,
    const DeformedPoint                 &at) const
  {
    const Tensor<2, dim> inverse = invert(deformation_gradient(at.gradient));
    return {inverse * stress.between * transpose(inverse),
            stress.across / std::pow(hoop_ratio(at.hoop), 2)};
  }



  template <int dim, int n_strains>
  void
  CellResponse<dim, n_strains>::set_means()
  {
    for (unsigned int q = 0; q < points_.size(); ++q)
      {
        const DeformedPoint  &at    = points_[q];
        const StartPoint     &start = start_[q];
        const ReferenceTensor end   = pull_back(work_stress(q), at);
        MeanPoint            &mean  = means_[q];

        mean.F = deformation_gradient(0.5 * (start.gradient + at.gradient));
        mean.hoop_ratio     = hoop_ratio(0.5 * (start.hoop + at.hoop));
        mean.stress.between = 0.5 * (start.work_stress.between + end.between);
        mean.stress.across  = 0.5 * (start.work_stress.across + end.across);
        mean.strain_change.between =
          symmetrize(transpose(mean.F) * (at.gradient - start.gradient));
        mean.strain_change.across = mean.hoop_ratio * (at.hoop - start.hoop);
      }
  }



  template <int dim, int n_strains>
  double
  CellResponse<dim, n_strains>::work_of(
    const ReferenceTensor MeanPoint::*const tensor) const
  {
    double work = 0.;
    for (unsigned int q = 0; q < points_.size(); ++q)
      {
        const ReferenceTensor &of     = means_[q].*tensor;
        const ReferenceTensor &change = means_[q].strain_change;
        work +=
          points_[q].volume * (scalar_product(of.between, change.between) +
                               of.across * change.across);
      }
    return work;
  }



  template <int dim, int n_strains>
  void
  CellResponse<dim, n_strains>::set_mean_force(const FEValues<dim> &values,
                                               const double missing_work)
  {
    // What is missing is along the change of strain.
    const double square = work_of(&MeanPoint::strain_change);
    const double lambda = square > 0. ? missing_work / square : 0.;
    mean_force          = 0.;
    for (unsigned int q = 0; q < points_.size(); ++q)
      {
        const MeanPoint     &mean = means_[q];
        const Tensor<2, dim> P =
          points_[q].volume * mean.F *
          (mean.stress.between + lambda * mean.strain_change.between);
        const double across =
          points_[q].volume * mean.hoop_ratio *
          (mean.stress.across + lambda * mean.strain_change.across);
        const double radius = values.quadrature_point(q)[0];
        for (const unsigned int a : values.dof_indices())
          {
            const Tensor<1, dim> share = P * values.shape_grad(a, q);
            for (unsigned int c = 0; c < dim; ++c)
              mean_force[a * dim + c] += share[c];
            if (is_axisymmetric_)
              mean_force[a * dim] += across * values.shape_value(a, q) / radius;
          }
      }
  }



  template <int dim, int n_strains>
  void
  CellResponse<dim, n_strains>::set_mean_tangent()
  {
    for (unsigned int q = 0; q < points_.size(); ++q)
      {
        DeformedPoint        &at    = points_[q];
        const StartPoint     &start = start_[q];
        const Tensor<2, dim>  F     = deformation_gradient(at.gradient);
        const ReferenceTensor end =
          pull_back(SpatialStress<dim, n_strains>(responses_[q].stress), at);
        const Tensor<2, dim> mean = 0.5 * (start.stress.between + end.between);
        const double         across = 0.5 * (start.stress.across + end.across) *
                              std::pow(hoop_ratio(at.hoop), 2);
        responses_[q].stress =
          SpatialStress<dim, n_strains>(F * mean * transpose(F), across)
            .reduced();
        at.turn =
          deformation_gradient(0.25 * start.gradient + 0.75 * at.gradient) *
          invert(F);
        at.hoop_turn =
          hoop_ratio(0.25 * start.hoop + 0.75 * at.hoop) / hoop_ratio(at.hoop);
      }
    if (has_mean_dilatation_)
      find_pressures();
  }



#define INSTANTIATE(dim, n_strains)                          \
  template void CellResponse<dim, n_strains>::evaluate_step( \
    const FEValues<dim> &,                                   \
    const std::vector<double> &,                             \
    const std::vector<double> &,                             \
    const Point &,                                           \
    const bool);
  INSTANTIATE(2, 3)
  INSTANTIATE(2, 4)
  INSTANTIATE(3, 6)
#undef INSTANTIATE
} // namespace Signorini
