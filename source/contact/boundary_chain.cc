#include <signorini/contact/boundary_chain.h>

#include <map>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    // A piece of the boundary that does not belong to the chain.
    struct OtherPiece
    {
      Node<2> start, end;
    };

    // The pieces of all other boundaries, by the first unknowns of their ends.
    std::multimap<unsigned int, OtherPiece>
    other_pieces(const Body<2> &body, const types::boundary_id id)
    {
      std::map<unsigned int, Node<2>> node_of_dof;
      for (const auto &node : body.nodes())
        node_of_dof[node.dofs[0]] = node;
      std::multimap<unsigned int, OtherPiece> pieces;
      const auto first_dof = [&](const auto &cell, const unsigned int vertex) {
        return body.first_dof() + cell->vertex_dof_index(vertex, 0);
      };
      for (const auto &cell : body.dof_handler().active_cell_iterators())
        for (const unsigned int f : cell->face_indices())
          {
            if (!cell->face(f)->at_boundary() ||
                cell->face(f)->boundary_id() == id)
              continue;
            const unsigned int start =
              first_dof(cell, GeometryInfo<2>::face_to_cell_vertices(f, 0));
            const unsigned int end =
              first_dof(cell, GeometryInfo<2>::face_to_cell_vertices(f, 1));
            pieces.insert({start, {node_of_dof[start], node_of_dof[end]}});
            pieces.insert({end, {node_of_dof[end], node_of_dof[start]}});
          }
      return pieces;
    }

    ChainEnd
    chain_end(const Node<2>                                 &node,
              const std::multimap<unsigned int, OtherPiece> &pieces,
              const DofMap                                  &dof_map)
    {
      ChainEnd   end;
      const auto found = pieces.find(node.dofs[0]);
      if (found == pieces.end())
        return end;
      const Node<2> &beyond   = found->second.end;
      end.beyond              = beyond;
      const Tensor<1, 2> edge = beyond.point - node.point;
      for (unsigned int c = 0; c < 2; ++c)
        if (dof_map.is_constrained(node.dofs[c]) &&
            dof_map.is_constrained(beyond.dofs[c]) &&
            std::abs(edge[c]) < 1e-8 * edge.norm())
          end.mirrored_component = c;
      return end;
    }
  } // namespace



  std::vector<BoundaryChain>
  boundary_chains(const Body<2>     &body,
                  const std::string &boundary,
                  const DofMap      &dof_map)
  {
    // 1. Who follows whom
    const ContactorSurface<2> surface = contactor_surface(body, boundary);
    std::map<unsigned int, unsigned int> next;
    std::vector<bool> has_previous(surface.nodes.size(), false);
    for (const auto &piece : surface.faces)
      {
        next[piece[0]]         = piece[1];
        has_previous[piece[1]] = true;
      }

    // 2. Open chains from their starts, then what is left are rings
    const auto pieces = other_pieces(body, body.mesh().boundary(boundary));
    std::vector<BoundaryChain> chains;
    const auto                 follow = [&](const unsigned int start) {
      BoundaryChain chain;
      unsigned int  node = start;
      while (true)
        {
          chain.nodes.push_back(surface.nodes[node]);
          const auto step = next.find(node);
          if (step == next.end())
            break;
          node = step->second;
          next.erase(step);
          if (node == start)
            {
              chain.is_closed = true;
              break;
            }
        }
      if (!chain.is_closed)
        chain.ends = {{chain_end(chain.nodes.front(), pieces, dof_map),
                       chain_end(chain.nodes.back(), pieces, dof_map)}};
      chains.push_back(chain);
    };
    for (unsigned int n = 0; n < surface.nodes.size(); ++n)
      if (!has_previous[n])
        follow(n);
    for (const auto &element : surface.elements)
      if (next.count(element.front()) > 0)
        follow(element.front());
    return chains;
  }
} // namespace Signorini
