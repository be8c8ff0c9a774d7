#ifndef signorini_run_state_watch_h
#define signorini_run_state_watch_h

#include <signorini/dynamics/state.h>
#include <signorini/output/log.h>
#include <signorini/run/overlap_watch.h>
#include <signorini/run/small_strain_watch.h>

namespace Signorini
{
  /**
   * Looks at the states that a run accepts for what its equations cannot say
   * themselves: bodies that lie in each other unseen, and small strains that
   * are not small.
   */
  template <int dim>
  class StateWatch
  {
  public:
    /** The problem must outlive the object. @throws InputError. */
    explicit StateWatch(const Problem<dim> &problem)
      : problem_(problem)
      , overlaps_(problem)
      , strains_(*problem.solid)
    {}

    /**
     * Warnings go to the log.
     * @param is_shown fields are written: overlaps are looked for in any case,
     *                 and not only after something has moved
     * @throws ComputationError.
     */
    void
    look(const State &state, const bool is_shown, Log &log);

    /** What there is to say at the end of the run. */
    void
    summarise(const State &state, Log &log) const;

  private:
    const Problem<dim>   &problem_;
    OverlapWatch<dim>     overlaps_;
    SmallStrainWatch<dim> strains_;
  };
} // namespace Signorini

#endif
