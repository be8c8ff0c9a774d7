#include <signorini/input/instantiate.h>
#include <signorini/run/state_watch.h>
#include <signorini/run/unpaired_bodies.h>

namespace Signorini
{
  template <int dim>
  void
  StateWatch<dim>::look(const State &state, const bool is_shown, Log &log)
  {
    const std::string warning = strains_.look(state.displacement, state.time);
    if (!warning.empty())
      log.line(warning);
    const Configuration configuration = state.configuration();
    if (is_shown || overlaps_.is_due(configuration))
      overlaps_.refuse(configuration);
  }



  template <int dim>
  void
  StateWatch<dim>::summarise(const State &state, Log &log) const
  {
    for (const std::string &warning :
         {strains_.summary(),
          overlaps_.summary(),
          unpaired_overlaps(problem_, state.displacement)})
      if (!warning.empty())
        log.line(warning);
  }



#define INSTANTIATE(dim) template class StateWatch<dim>;
  SIGNORINI_FOR_EACH_DIMENSION(INSTANTIATE)
#undef INSTANTIATE
} // namespace Signorini
