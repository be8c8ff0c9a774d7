#include "node_constraints.h"

#include <signorini/input/input_error.h>

#include <deal.II/dofs/dof_tools.h>

#include <sstream>

namespace Signorini
{
  using namespace dealii;

  template <int dim>
  void
  add_hanging_nodes(const Body<dim>           &body,
                    AffineConstraints<double> &constraints)
  {
    AffineConstraints<double> local;
    DoFTools::make_hanging_node_constraints(body.dof_handler(), local);
    local.close();
    const unsigned int shift = body.first_dof();
    for (const auto &line : local.get_lines())
      {
        constraints.add_line(line.index + shift);
        for (const auto &[dof, weight] : line.entries)
          constraints.add_entry(line.index + shift, dof + shift, weight);
      }
  }



  template <int dim>
  void
  hold_in_plane(const Body<dim>           &body,
                const SlidingNode<dim>    &sliding,
                const std::vector<bool>   &is_given,
                const std::vector<bool>   &is_hanging,
                AffineConstraints<double> &constraints)
  {
    if (is_hanging[sliding.node.dofs[0]])
      return;
    const auto  &dofs     = sliding.node.dofs;
    const auto  &normal   = sliding.normal;
    unsigned int follower = dim;
    for (unsigned int c = 0; c < dim; ++c)
      {
        if (constraints.is_constrained(dofs[c]))
          {
            std::ostringstream message;
            message << "Body " << body.name() << " / Supports / Sliding: two "
                    << "boundaries meet at (" << sliding.node.point
                    << "). Fix the node there, or let one of them slide.";
            throw InputError(message.str());
          }
        if (!is_given[dofs[c]] &&
            (follower == dim ||
             std::abs(normal[c]) > std::abs(normal[follower])))
          follower = c;
      }
    if (follower == dim || std::abs(normal[follower]) < 1e-6)
      return;
    constraints.add_line(dofs[follower]);
    for (unsigned int c = 0; c < dim; ++c)
      if (c != follower && normal[c] != 0.)
        constraints.add_entry(dofs[follower],
                              dofs[c],
                              -normal[c] / normal[follower]);
  }



  template void
  add_hanging_nodes(const Body<2> &, AffineConstraints<double> &);
  template void
  add_hanging_nodes(const Body<3> &, AffineConstraints<double> &);
  template void
  hold_in_plane(const Body<2> &,
                const SlidingNode<2> &,
                const std::vector<bool> &,
                const std::vector<bool> &,
                AffineConstraints<double> &);
  template void
  hold_in_plane(const Body<3> &,
                const SlidingNode<3> &,
                const std::vector<bool> &,
                const std::vector<bool> &,
                AffineConstraints<double> &);
} // namespace Signorini
