#include <signorini/time/step_plan.h>

#include <algorithm>
#include <cmath>

namespace Signorini
{
  namespace
  {
    // Times of steps are sums; this much is rounding.
    constexpr double rounding_of_time = 1e-9;

    // A last step that would be tiny is added to the one before.
    unsigned int
    n_grid_steps(const double step_size, const double end_time)
    {
      return std::max(1., std::ceil(end_time / step_size - 1e-3));
    }
  } // namespace



  StepPlan::StepPlan(const StepControl         &control,
                     const double               end_time,
                     const std::vector<double> &output_times,
                     const double               output_interval)
    : is_automatic_(control.automatic)
    , step_size_(control.initial_size)
    , end_time_(end_time)
    , interval_(control.automatic ? output_interval : 0.)
    , times_(control.times_to_meet)
    , n_grid_steps_(n_grid_steps(step_size_, end_time))
  {
    if (is_automatic_)
      times_.insert(times_.end(), output_times.begin(), output_times.end());
    std::sort(times_.begin(), times_.end());
  }



  unsigned int
  StepPlan::n_regular_steps() const
  {
    return is_automatic_ ? 0 : n_grid_steps_;
  }



  double
  StepPlan::grid_time(const unsigned int k) const
  {
    return k >= n_grid_steps_ ? end_time_ : k * step_size_;
  }



  bool
  StepPlan::is_met(const double time, const double target)
  {
    return time >= target * (1. - rounding_of_time);
  }



  double
  StepPlan::target(const double time, const unsigned int n_regular) const
  {
    double     target = is_automatic_ ? end_time_ : grid_time(n_regular + 1);
    const auto next =
      std::find_if(times_.begin(), times_.end(), [time](const double listed) {
        return !is_met(time, listed);
      });
    if (next != times_.end())
      target = std::min(target, *next);
    if (interval_ > 0.)
      target = std::min(target,
                        (std::floor(time / interval_ + rounding_of_time) + 1.) *
                          interval_);
    return target;
  }



  bool
  StepPlan::completes_regular_step(const double       time,
                                   const unsigned int n_regular) const
  {
    return is_automatic_ || is_met(time, grid_time(n_regular + 1));
  }



  unsigned int
  StepPlan::n_regular_at(const double time, const unsigned int n_regular) const
  {
    unsigned int n = n_regular;
    while (!is_automatic_ && n > 0 && !is_met(time, n * step_size_))
      --n;
    return n;
  }



  bool
  StepPlan::is_end(const double time) const
  {
    return is_met(time, end_time_);
  }
} // namespace Signorini
