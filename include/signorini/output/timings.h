#ifndef signorini_output_timings_h
#define signorini_output_timings_h

#include <chrono>
#include <string>
#include <vector>

namespace Signorini
{
  /**
   * Wall-clock time by named section, cheap enough for steps of 0.2 ms: a
   * scope costs two readings of the clock (some 50 ns). deal.II's TimerOutput
   * reduces over MPI and asks the system for CPU time at every scope, which
   * costs more than such a step.
   *
   * A section is charged only for its own time: while an inner scope runs, the
   * outer one stands still. So nothing is counted twice, sections may be
   * nested and recursive, and the seconds of all sections and of the line
   * "other" add up to the total.
   *
   *   const unsigned int assembly = timings.add("assembly");  // once
   *   ...
   *   const auto timing = timings.measure(assembly);          // every step
   *
   * One thread only: measure around parallel loops, not inside them.
   */
  class Timings
  {
  public:
    /** Charges a section from its creation to its end. */
    class Scope
    {
    public:
      ~Scope();

      Scope(const Scope &) = delete;
      Scope &
      operator=(const Scope &) = delete;

    private:
      friend class Timings;
      Scope(Timings &timings, const unsigned int section);

      Timings           &timings;
      const unsigned int outer;
    };

    /** The total runs from here on. */
    Timings();

    // A scope refers to the object it was made by.
    Timings(const Timings &) = delete;
    Timings &
    operator=(const Timings &) = delete;

    /**
     * The index of the section of this name, which is created at the first
     * call. Sections appear in the table in this order.
     */
    unsigned int
    add(const std::string &name);

    [[nodiscard]] Scope
    measure(const unsigned int section);

    /** The same by name, with a search through the few names there are. */
    [[nodiscard]] Scope
    measure(const std::string &name);

    /** Own time of a section so far; 0 for a name unknown. Unit: s. */
    double
    seconds(const std::string &name) const;

    /** How often a section was entered; 0 for a name unknown. */
    unsigned long
    n_calls(const std::string &name) const;

    /** Time since the construction. Unit: s. */
    double
    total_seconds() const;

    /**
     * A table with the seconds, the share of the total and the number of calls
     * of every section that was entered, the rest as "other", and the total.
     */
    std::string
    table() const;

  private:
    using Clock = std::chrono::steady_clock;

    struct Section
    {
      std::string     name;
      Clock::duration time    = Clock::duration::zero();
      unsigned long   n_calls = 0;
    };

    // Charge the running section up to now and let another one run.
    void
    switch_to(const unsigned int section);

    const Section *
    find(const std::string &name) const;

    // Section 0 is "other": the time outside of every scope.
    std::vector<Section>    sections;
    const Clock::time_point start;
    Clock::time_point       last_switch;
    unsigned int            running = 0;
  };
} // namespace Signorini

#endif
