#include "node_constraints.h"

#include <signorini/input/input_error.h>
#include <signorini/input/instantiate.h>

#include <deal.II/dofs/dof_tools.h>

#include <sstream>

namespace Signorini
{
  using namespace dealii;

  template <int dim>
  void
  add_hanging_nodes(const Body<dim> &body, DofMap &dof_map)
  {
    AffineConstraints<double> local;
    DoFTools::make_hanging_node_constraints(body.dof_handler(), local);
    local.close();
    const unsigned int shift = body.first_dof();
    for (const auto &line : local.get_lines())
      {
        std::vector<std::pair<unsigned int, double>> masters;
        for (const auto &[dof, weight] : line.entries)
          masters.emplace_back(dof + shift, weight);
        dof_map.hang(line.index + shift, masters);
      }
  }



  template <int dim>
  void
  hold_in_plane(const Body<dim>        &body,
                const SlidingNode<dim> &sliding,
                DofMap                 &dof_map)
  {
    if (dof_map.is_hanging(sliding.node.dofs[0]))
      return;
    const auto  &dofs     = sliding.node.dofs;
    const auto  &normal   = sliding.normal;
    unsigned int follower = dim;
    for (unsigned int c = 0; c < dim; ++c)
      {
        if (dof_map.constraints().is_constrained(dofs[c]))
          {
            std::ostringstream message;
            message << "two boundaries meet at (" << sliding.node.point
                    << "). Fix the node there, or let one of them slide.";
            throw InputError("Body " + body.name() + " / Supports / Sliding",
                             message.str());
          }
        if (!dof_map.is_prescribed(dofs[c]) &&
            (follower == dim ||
             std::abs(normal[c]) > std::abs(normal[follower])))
          follower = c;
      }
    if (follower == dim || std::abs(normal[follower]) < 1e-6)
      return;
    std::vector<std::pair<unsigned int, double>> others;
    for (unsigned int c = 0; c < dim; ++c)
      if (c != follower && normal[c] != 0.)
        others.emplace_back(dofs[c], -normal[c] / normal[follower]);
    dof_map.follow(dofs[follower], others);
  }



#define INSTANTIATE(dim)                                        \
  template void add_hanging_nodes(const Body<dim> &, DofMap &); \
  template void hold_in_plane(const Body<dim> &,                \
                              const SlidingNode<dim> &,         \
                              DofMap &);
  SIGNORINI_FOR_EACH_DIMENSION(INSTANTIATE)
#undef INSTANTIATE
} // namespace Signorini
