#ifndef signorini_output_time_series_h
#define signorini_output_time_series_h

#include <stdexcept>
#include <string>
#include <vector>

namespace Signorini
{
  /**
   * A quantity that was asked for, but that this run does not have: a
   * condition that never held, a time beyond the end, no rows at all.
   */
  class NoValue : public std::runtime_error
  {
  public:
    using std::runtime_error::runtime_error;
  };

  /**
   * One quantity over time, at times that do not decrease. Between the times
   * it is taken as linear.
   */
  struct TimeSeries
  {
    std::vector<double> times;
    std::vector<double> values;
  };

  /** A condition `quantity > threshold`, with one of four comparisons. */
  struct Condition
  {
    enum class Comparison
    {
      less,
      less_or_equal,
      greater,
      greater_or_equal
    };

    Comparison comparison = Comparison::greater;
    double     threshold  = 0.;

    bool
    holds(const double value) const;
  };

  /**
   * The rows with begin <= time <= end. Times are compared with a tolerance of
   * 1e-9 of the largest time, as sums of step sizes carry rounding errors.
   * @throws NoValue when the series does not cover the window or has no row
   * in it.
   */
  TimeSeries
  rows_between(const TimeSeries &series, const double begin, const double end);

  /**
   * The part of the piecewise linear function between two times, with values
   * interpolated at both. @throws NoValue when the series does not cover it.
   */
  TimeSeries
  part_between(const TimeSeries &series, const double begin, const double end);

  /**
   * The value at a time, linear between the rows; where the series jumps (two
   * rows of the same time) the later row. @throws NoValue outside the series.
   */
  double
  interpolate(const TimeSeries &series, const double time);

  /**
   * Largest, smallest, and largest absolute value of the rows, and the value
   * of the last row. A NaN anywhere makes the first three NaN.
   * @throws NoValue without rows, as the functions below.
   */
  double
  maximum(const TimeSeries &series);
  double
  minimum(const TimeSeries &series);
  double
  maximum_absolute(const TimeSeries &series);
  double
  final_value(const TimeSeries &series);

  /**
   * Mean over time, (1/T) int u dt by the trapezoidal rule, so that short
   * steps weigh less than long ones; of a single time the mean of its rows.
   */
  double
  mean(const TimeSeries &series);

  /** Time of the first and last row where the condition holds. */
  double
  first_time(const TimeSeries &series, const Condition &condition);
  double
  last_time(const TimeSeries &series, const Condition &condition);

  /**
   * Times of the rows where the condition differs from the row before. Before
   * the first row it counts as false. So the entries 0, 2, ... are the times
   * it becomes true, the entries 1, 3, ... the times it becomes false.
   */
  std::vector<double>
  switch_times(const TimeSeries &series, const Condition &condition);
} // namespace Signorini

#endif
