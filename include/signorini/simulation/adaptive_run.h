#ifndef signorini_simulation_adaptive_run_h
#define signorini_simulation_adaptive_run_h

#include <signorini/output/log.h>
#include <signorini/output/timings.h>
#include <signorini/simulation/problem.h>

#include <functional>
#include <string>
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
   * table of the meshes goes to meshes.csv in the folder.
   * @param problem on its first mesh
   * @return the refinements of each body
   * @throws InputError, ComputationError, Interrupted.
   */
  template <int dim>
  std::vector<RefinementPasses>
  adapt_meshes(const ProblemCreator<dim> &create,
               const std::string         &folder,
               Problem<dim>              &problem,
               Timings                   &timings,
               Log                       &log);
} // namespace Signorini

#endif
