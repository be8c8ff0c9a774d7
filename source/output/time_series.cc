#include <signorini/output/time_series.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace Signorini
{
  namespace
  {
    void
    require_rows(const TimeSeries &series)
    {
      AssertDimension(series.times.size(), series.values.size());
      if (series.times.empty())
        throw NoValue("there are no rows");
    }

    double
    time_tolerance(const TimeSeries &series)
    {
      return 1e-9 * std::max(std::abs(series.times.front()),
                             std::abs(series.times.back()));
    }

    void
    require_covered(const TimeSeries &series, const double time)
    {
      require_rows(series);
      const double tolerance = time_tolerance(series);
      // Written so that NaN is refused, too.
      if (time >= series.times.front() - tolerance &&
          time <= series.times.back() + tolerance)
        return;
      std::ostringstream text;
      text << "the time " << time << " s lies outside the run, which covers "
           << series.times.front() << " s to " << series.times.back() << " s";
      throw NoValue(text.str());
    }

    template <class Better>
    double
    best_value(const TimeSeries &series, const Better &better)
    {
      require_rows(series);
      double best = series.values.front();
      for (const double value : series.values)
        {
          if (std::isnan(value))
            return std::numeric_limits<double>::quiet_NaN();
          if (better(value, best))
            best = value;
        }
      return best;
    }
  } // namespace



  bool
  Condition::holds(const double value) const
  {
    switch (comparison)
      {
        case Comparison::less:
          return value < threshold;
        case Comparison::less_or_equal:
          return value <= threshold;
        case Comparison::greater:
          return value > threshold;
        case Comparison::greater_or_equal:
          return value >= threshold;
      }
    Assert(false, dealii::ExcInternalError());
    return false;
  }



  TimeSeries
  rows_between(const TimeSeries &series, const double begin, const double end)
  {
    require_covered(series, begin);
    require_covered(series, end);
    const double tolerance = time_tolerance(series);
    TimeSeries   rows;
    for (unsigned int i = 0; i < series.times.size(); ++i)
      if (series.times[i] >= begin - tolerance &&
          series.times[i] <= end + tolerance)
        {
          rows.times.push_back(series.times[i]);
          rows.values.push_back(series.values[i]);
        }
    if (rows.times.empty())
      throw NoValue("there are no rows in the time window");
    return rows;
  }



  TimeSeries
  part_between(const TimeSeries &series, const double begin, const double end)
  {
    TimeSeries part;
    part.times.push_back(begin);
    part.values.push_back(interpolate(series, begin));
    for (unsigned int i = 0; i < series.times.size(); ++i)
      if (series.times[i] > begin && series.times[i] < end)
        {
          part.times.push_back(series.times[i]);
          part.values.push_back(series.values[i]);
        }
    part.times.push_back(end);
    part.values.push_back(interpolate(series, end));
    return part;
  }



  double
  interpolate(const TimeSeries &series, const double time)
  {
    require_covered(series, time);
    const auto next =
      std::upper_bound(series.times.begin(), series.times.end(), time);
    if (next == series.times.begin())
      return series.values.front();
    if (next == series.times.end())
      return series.values.back();
    const std::size_t i = next - series.times.begin();
    const double      weight =
      (time - series.times[i - 1]) / (series.times[i] - series.times[i - 1]);
    return (1. - weight) * series.values[i - 1] + weight * series.values[i];
  }



  double
  maximum(const TimeSeries &series)
  {
    return best_value(series,
                      [](const double a, const double b) { return a > b; });
  }



  double
  minimum(const TimeSeries &series)
  {
    return best_value(series,
                      [](const double a, const double b) { return a < b; });
  }



  double
  maximum_absolute(const TimeSeries &series)
  {
    return std::abs(best_value(series, [](const double a, const double b) {
      return std::abs(a) > std::abs(b);
    }));
  }



  double
  final_value(const TimeSeries &series)
  {
    require_rows(series);
    return series.values.back();
  }



  double
  mean(const TimeSeries &series)
  {
    require_rows(series);
    const double duration = series.times.back() - series.times.front();
    double       integral = 0.;
    double       sum      = series.values.front();
    for (unsigned int i = 1; i < series.times.size(); ++i)
      {
        integral += (series.times[i] - series.times[i - 1]) *
                    (series.values[i] + series.values[i - 1]) / 2.;
        sum += series.values[i];
      }
    return duration > 0. ? integral / duration : sum / series.times.size();
  }



  double
  first_time(const TimeSeries &series, const Condition &condition)
  {
    require_rows(series);
    for (unsigned int i = 0; i < series.times.size(); ++i)
      if (condition.holds(series.values[i]))
        return series.times[i];
    throw NoValue("the condition never holds");
  }



  double
  last_time(const TimeSeries &series, const Condition &condition)
  {
    require_rows(series);
    for (unsigned int i = series.times.size(); i > 0; --i)
      if (condition.holds(series.values[i - 1]))
        return series.times[i - 1];
    throw NoValue("the condition never holds");
  }



  std::vector<double>
  switch_times(const TimeSeries &series, const Condition &condition)
  {
    require_rows(series);
    std::vector<double> times;
    bool                held = false;
    for (unsigned int i = 0; i < series.times.size(); ++i)
      if (condition.holds(series.values[i]) != held)
        {
          held = !held;
          times.push_back(series.times[i]);
        }
    return times;
  }
} // namespace Signorini
