#ifndef signorini_run_unpaired_bodies_h
#define signorini_run_unpaired_bodies_h

#include <signorini/linear_algebra/types.h>
#include <signorini/run/problem.h>

#include <string>

namespace Signorini
{
  /**
   * A line for each two deformable bodies that lie in each other although no
   * contact pair keeps them apart: a pair may have been forgotten. Looked for
   * at their nodes, and left alone up to a hundredth of the largest cell.
   */
  template <int dim>
  std::string
  unpaired_overlaps(const Problem<dim> &problem, const DofVector &displacement);
} // namespace Signorini

#endif
