// The part of TimeStep that judges an iterate.
#include <signorini/dynamics/time_step.h>
#include <signorini/input/as_text.h>
#include <signorini/input/instantiate.h>
#include <signorini/linear_algebra/types.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    // Within so many times their rounding forces are in balance; where they do
    // not get better any more, so much is accepted.
    constexpr double rounding_share = 4.;
    constexpr double floor_multiple = 1000.;

    // Of a static step, relative to the bodies: beyond it forces are rounding.
    constexpr double largest_motion = 1e3;

    double
    largest_change(const InterfaceForces &old_forces,
                   const InterfaceForces &new_forces)
    {
      double change = 0.;
      for (unsigned int k = 0; k < new_forces.normal.size(); ++k)
        {
          change =
            std::max(change,
                     std::abs(new_forces.normal[k] - old_forces.normal[k]));
          for (unsigned int j = 0; j < 2; ++j)
            change = std::max(change,
                              std::abs(new_forces.tangential[k][j] -
                                       old_forces.tangential[k][j]));
        }
      return change;
    }

    double
    largest_normal(const InterfaceForces &forces)
    {
      double largest = 0.;
      for (const double normal : forces.normal)
        largest = std::max(largest, normal);
      return largest;
    }

    void
    add_absolute_product(const DofMatrix &matrix,
                         const DofVector &values,
                         const double     factor,
                         DofVector       &result)
    {
      for (unsigned int i = 0; i < result.size(); ++i)
        for (auto entry = matrix.begin(i); entry != matrix.end(i); ++entry)
          result[i] +=
            factor * std::abs(entry->value() * values[entry->column()]);
    }
  } // namespace



  template <int dim>
  void
  TimeStep<dim>::measure_balance(const double step_size,
                                 DofVector    residual,
                                 const std::vector<ContactPoint<dim>> &points,
                                 const InterfaceForces &multipliers,
                                 State                 &state)
  {
    const auto timing = timings_.measure(section_residual_);
    contact_.add_contact_forces(points, multipliers, 1., residual);
    for (unsigned int i = 0; i < largest_displacement_.size(); ++i)
      largest_displacement_[i] =
        std::max(largest_displacement_[i], std::abs(state.displacement[i]));
    const double scale   = force_scale(state, multipliers);
    double       largest = 0.;
    for (unsigned int i = 0; i < residual.size(); ++i)
      if (!solid_.dof_map().is_constrained(i))
        largest = std::isnan(residual[i]) ?
                    std::numeric_limits<double>::infinity() :
                    std::max(largest, std::abs(residual[i]));
    rounding_multiple_ = 0.;
    if (state.n_iterations > 0 && std::isfinite(largest) &&
        largest > settings_.time.residual_tolerance * scale)
      {
        const DofVector rounding = force_rounding(step_size);
        largest                  = 0.;
        for (unsigned int i = 0; i < residual.size(); ++i)
          if (!solid_.dof_map().is_constrained(i) && residual[i] != 0.)
            {
              const double size = std::abs(residual[i]);
              largest = std::max(largest, size - rounding_share * rounding[i]);
              rounding_multiple_ =
                std::max(rounding_multiple_, size / rounding[i]);
            }
      }
    // A scale without end does not make a residual small.
    state.residual = largest == 0. ? 0. :
                     std::isfinite(scale) ?
                                     largest / scale :
                                     std::numeric_limits<double>::infinity();
    residuals_.push_back(state.residual);
  }



  template <int dim>
  DofVector
  TimeStep<dim>::force_rounding(const double step_size) const
  {
    DofVector rounding = solid_.force_rounding(largest_displacement_);
    if (!settings_.time.dynamic)
      return rounding;
    // Accelerations are differences of displacements, over the square of time.
    const double factor = std::numeric_limits<double>::epsilon() *
                          effective_factors(step_size).mass;
    add_absolute_product(solid_.mass(),
                         largest_displacement_,
                         factor,
                         rounding);
    return rounding;
  }



  template <int dim>
  double
  TimeStep<dim>::force_scale(const State           &state,
                             const InterfaceForces &multipliers) const
  {
    return std::max({state.external_force.linfty_norm(),
                     state.internal_force.linfty_norm(),
                     largest_mass_ * state.acceleration.linfty_norm(),
                     largest_normal(multipliers)});
  }



  template <int dim>
  double
  TimeStep<dim>::relative_force_change(const double           step_size,
                                       const State           &state,
                                       const InterfaceForces &old_multipliers,
                                       const InterfaceForces &multipliers) const
  {
    const double change = largest_change(old_multipliers, multipliers);
    if (change == 0.)
      return 0.;
    const double largest =
      std::max(largest_normal(old_multipliers), largest_normal(multipliers));
    if (change <= settings_.force_tolerance * largest)
      return change / largest;
    // Of a touch without pressure forces are rounding, and never settle: that
    // of the bodies, or what presses a gap as wide as rounding.
    const double rounding = force_rounding(step_size).linfty_norm() +
                            largest_stiffness_ * contact_.rounding();
    const double negligible = std::max(settings_.time.residual_tolerance *
                                         force_scale(state, multipliers),
                                       floor_multiple * rounding);
    return change / std::max(largest, negligible / settings_.force_tolerance);
  }



  template <int dim>
  bool
  TimeStep<dim>::is_balanced(const State &state) const
  {
    if (state.residual <= settings_.time.residual_tolerance)
      return true;
    // Rounding is where iterations do not help any more.
    const auto last = residuals_.end() - 1;
    return residuals_.size() > 2 && rounding_multiple_ <= floor_multiple &&
           *last > 0.5 * *std::min_element(residuals_.begin(), last);
  }



  template <int dim>
  std::optional<typename TimeStep<dim>::UnmetCriterion>
  TimeStep<dim>::unmet_criterion(const State                          &state,
                                 const std::vector<ContactPoint<dim>> &points,
                                 const Iterate &iterate) const
  {
    if (state.n_iterations == 0 || !is_balanced(state))
      return unmet_balance(state);
    if (!(state.kkt_residual <= settings_.time.residual_tolerance))
      return UnmetCriterion{
        "the contact conditions of the last iteration, interface residual " +
          as_text(state.kkt_residual) + " (allowed " +
          as_text(settings_.time.residual_tolerance) + ")",
        "Try another Contact / Algorithm on the interface problem that was "
        "written"};
    if (contact_.is_flat())
      return {};
    if (!(iterate.force_change <= settings_.force_tolerance))
      return UnmetCriterion{
        "the contact forces, which still change by " +
          as_text(iterate.force_change) + " of the largest (allowed " +
          as_text(settings_.force_tolerance) + ")",
        "Contacts come and go from one iteration to the next: smaller steps, "
        "Surface = spline or a finer mesh there help"};
    if (!system_->enforces_exactly())
      return {};
    return unmet_gap(state, points, iterate);
  }



  template <int dim>
  std::optional<typename TimeStep<dim>::UnmetCriterion>
  TimeStep<dim>::unmet_gap(const State                          &state,
                           const std::vector<ContactPoint<dim>> &points,
                           const Iterate                        &iterate) const
  {
    // What the curvature of a target adds to a linearised gap is of second
    // order in the last motion.
    const double tolerance = 1e-6 * iterate.motion +
                             1e-10 * state.displacement.linfty_norm() +
                             contact_.rounding();
    for (unsigned int k = 0; k < points.size(); ++k)
      {
        const double gap = points[k].gap;
        if (gap < -tolerance ||
            (iterate.multipliers.normal[k] > 0. && gap > tolerance))
          return UnmetCriterion{
            "the gap of " + contact_.candidates_in_words({k}) + ", " +
              as_text(gap) + " m where " + (gap < 0. ? "none" : "contact") +
              " was expected (allowed " + as_text(tolerance) + " m)",
            "The target turns too much within an iteration: smaller steps, or "
            "a finer mesh of the target help"};
      }
    return {};
  }



  template <int dim>
  typename TimeStep<dim>::UnmetCriterion
  TimeStep<dim>::unmet_balance(const State &state) const
  {
    UnmetCriterion unmet;
    unmet.found = "the balance of forces, unbalanced " +
                  as_text(state.residual) + " of the largest force (allowed " +
                  as_text(settings_.time.residual_tolerance) + ")";
    const unsigned int n = residuals_.size();
    const double       ratio =
      n < 4 ? 1. : std::cbrt(residuals_[n - 1] / residuals_[n - 4]);
    if (std::isfinite(ratio) && ratio < 0.95)
      {
        const double left =
          std::log(settings_.time.residual_tolerance / state.residual) /
          std::log(ratio);
        unmet.remedy = "It falls by " + as_text(ratio) +
                       " an iteration: Maximal iterations = " +
                       as_text(std::ceil(1.5 * (n + left))) + " would do";
      }
    else
      unmet.remedy = "It does not fall: look at the last fields for what "
                     "happens there; smaller steps, or a finer mesh where "
                     "contact happens may help";
    return unmet;
  }



  template <int dim>
  std::string
  TimeStep<dim>::failure_message(const State          &state,
                                 const UnmetCriterion &unmet) const
  {
    std::ostringstream message;
    message << "not converged after " << state.n_iterations
            << (state.n_iterations == 1 ? " iteration" : " iterations")
            << ". Not met is " << unmet.found;
    if (!indefinite_at_.empty())
      message << "; the stiffness was not positive definite at "
              << indefinite_at_;
    message << ". " << unmet.remedy;
    return message.str();
  }



  template <int dim>
  void
  TimeStep<dim>::refuse_collapse(const State &old_state,
                                 const State &state) const
  {
    if (settings_.time.dynamic)
      return;
    DofVector motion(state.displacement);
    motion -= old_state.displacement;
    if (!(motion.linfty_norm() > largest_motion * extent_))
      return;
    std::ostringstream message;
    message << "displacements grew by " << motion.linfty_norm()
            << " m, while all bodies together are " << extent_
            << " m wide: the bodies do not carry the load";
    throw StepFailed(message.str());
  }



  template <int dim>
  void
  TimeStep<dim>::refuse_tunnelling(const State   &old_state,
                                   const Iterate &iterate,
                                   const State   &state) const
  {
    const auto        timing = timings_.measure(section_contact_);
    std::vector<bool> closed(contact_.n_contacts());
    for (unsigned int k = 0; k < closed.size(); ++k)
      closed[k] = iterate.multipliers.normal[k] > 0. ||
                  old_state.contact.forces.normal[k] > 0.;
    const auto passed =
      contact_.tunnelling_candidates(state.configuration(),
                                     old_state.configuration(),
                                     old_state.contact.gaps,
                                     closed);
    if (!passed.empty())
      throw StepFailed("nodes pass through a surface within the step: " +
                       contact_.candidates_in_words(passed));
  }



#define INSTANTIATE(dim)                                                                                  \
  template void TimeStep<dim>::refuse_collapse(const State &, const State &)                              \
    const;                                                                                                \
  template void TimeStep<dim>::refuse_tunnelling(const State &,                                           \
                                                 const Iterate &,                                         \
                                                 const State &) const;                                    \
  template void TimeStep<dim>::measure_balance(                                                           \
    const double,                                                                                         \
    DofVector,                                                                                            \
    const std::vector<ContactPoint<dim>> &,                                                               \
    const InterfaceForces &,                                                                              \
    State &);                                                                                             \
  template DofVector TimeStep<dim>::force_rounding(const double) const;                                   \
  template double    TimeStep<dim>::force_scale(const State &,                                            \
                                             const InterfaceForces &) const;                           \
  template double    TimeStep<dim>::relative_force_change(                                                \
    const double,                                                                                      \
    const State &,                                                                                     \
    const InterfaceForces &,                                                                           \
    const InterfaceForces &) const;                                                                    \
  template bool TimeStep<dim>::is_balanced(const State &) const;                                          \
  template std::optional<TimeStep<dim>::UnmetCriterion>                                                   \
  TimeStep<dim>::unmet_criterion(const State &,                                                           \
                                 const std::vector<ContactPoint<dim>> &,                                  \
                                 const Iterate &) const;                                                  \
  template std::optional<TimeStep<dim>::UnmetCriterion>                                                   \
                                         TimeStep<dim>::unmet_gap(const State &,                          \
                           const std::vector<ContactPoint<dim>> &, \
                           const Iterate &) const;                 \
  template TimeStep<dim>::UnmetCriterion TimeStep<dim>::unmet_balance(                                    \
    const State &) const;                                                                                 \
  template std::string TimeStep<dim>::failure_message(const State &,                                      \
                                                      const UnmetCriterion &)                             \
    const;
  SIGNORINI_FOR_EACH_DIMENSION(INSTANTIATE)
#undef INSTANTIATE
} // namespace Signorini
