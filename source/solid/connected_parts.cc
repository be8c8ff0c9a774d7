#include <signorini/input/instantiate.h>
#include <signorini/solid/connected_parts.h>

#include <boost/pending/disjoint_sets.hpp>

#include <map>
#include <numeric>

namespace Signorini
{
  using namespace dealii;

  template <int dim>
  std::vector<std::vector<Node<dim>>>
  connected_parts(const Body<dim> &body)
  {
    std::vector<unsigned int> rank(body.n_dofs(), 0), parent(body.n_dofs());
    std::iota(parent.begin(), parent.end(), 0);
    boost::disjoint_sets<unsigned int *, unsigned int *> sets(rank.data(),
                                                              parent.data());
    std::vector<types::global_dof_index> dofs(body.fe().n_dofs_per_cell());
    for (const auto &cell : body.dof_handler().active_cell_iterators())
      {
        cell->get_dof_indices(dofs);
        for (const auto dof : dofs)
          sets.union_set(dofs[0], dof);
      }

    std::map<unsigned int, unsigned int> part_of_root;
    std::vector<std::vector<Node<dim>>>  parts;
    for (const auto &node : body.nodes())
      {
        const auto [part, is_new] =
          part_of_root.emplace(sets.find_set(node.dofs[0] - body.first_dof()),
                               parts.size());
        if (is_new)
          parts.emplace_back();
        parts[part->second].push_back(node);
      }
    return parts;
  }



#define INSTANTIATE(dim)                                        \
  template std::vector<std::vector<Node<dim>>> connected_parts( \
    const Body<dim> &);
  SIGNORINI_FOR_EACH_DIMENSION(INSTANTIATE)
#undef INSTANTIATE
} // namespace Signorini
