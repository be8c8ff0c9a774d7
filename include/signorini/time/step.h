#ifndef signorini_time_step_h
#define signorini_time_step_h

namespace Signorini
{
  /**
   * A step in time, as it was chosen. Its size is never computed from times
   * again: the difference of two of them is the size but for rounding, and
   * what was factorised for the one would not be found for the other.
   */
  struct Step
  {
    unsigned int number; // 1: the first of the run
    double       begin;  // s
    double       size;   // s

    double
    end() const
    {
      return begin + size;
    }
  };
} // namespace Signorini

#endif
