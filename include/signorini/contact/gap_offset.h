#ifndef signorini_contact_gap_offset_h
#define signorini_contact_gap_offset_h

#include <vector>

namespace Signorini
{
  /**
   * What is added to the gaps of the candidates of a pair: depths by which they
   * may be inside of their target at t = 0, less and less until an end time,
   * and not at all from then on (press fit); or for ever, if the time is
   * infinite (adjust).
   */
  class GapOffset
  {
  public:
    /** None. */
    GapOffset() = default;

    /**
     * @param depths   of each candidate of the pair, m
     * @param end_time s
     */
    GapOffset(std::vector<double> depths, const double end_time)
      : depths_(std::move(depths))
      , end_time_(end_time)
    {}

    /** Of a candidate of the pair at a time, m. */
    double
    value(const unsigned int candidate, const double time) const
    {
      // 1 - t / infinity is one.
      const double share = 1. - time / end_time_;
      return depths_.empty() || share <= 0. ? 0. : share * depths_[candidate];
    }

    /** True for a candidate that was inside of its target at t = 0. */
    bool
    was_inside(const unsigned int candidate) const
    {
      return !depths_.empty() && depths_[candidate] != 0.;
    }

  private:
    std::vector<double> depths_; // m; empty: nothing
    double              end_time_ = 0.;
  };
} // namespace Signorini

#endif
