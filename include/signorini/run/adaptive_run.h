#ifndef signorini_run_adaptive_run_h
#define signorini_run_adaptive_run_h

#include <signorini/output/log.h>
#include <signorini/output/timings.h>
#include <signorini/run/problem.h>
#include <signorini/run/simulation.h>

#include <functional>
#include <vector>

namespace Signorini
{
  /** Makes the problem with these refinements of its bodies. */
  template <int dim>
  using ProblemCreator =
    std::function<Problem<dim>(const std::vector<RefinementPasses> &)>;

  /**
   * Solves the problem up to `Adaptivity / Time' on one mesh after the other
   * until MeshAdaptation is content, and leaves it on the last of them. The
   * table of the meshes goes to meshes.csv in the folder. Whenever a mesh was
   * found a checkpoint is written, with which the search goes on if it is that
   * of the task.
   * @param task    gets the refinements of each body, and no checkpoint is left
   * @param problem on the first mesh, or the last one of the checkpoint
   * @throws InputError, ComputationError, Interrupted.
   */
  template <int dim>
  void
  adapt_meshes(const ProblemCreator<dim> &create,
               RunTask                   &task,
               Problem<dim>              &problem,
               Timings                   &timings,
               Log                       &log);
} // namespace Signorini

#endif
