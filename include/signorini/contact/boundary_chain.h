#ifndef signorini_contact_boundary_chain_h
#define signorini_contact_boundary_chain_h

#include <signorini/contact/contactor_surface.h>
#include <signorini/solid/dof_map.h>

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace Signorini
{
  /** How the boundary of a body goes on where a chain of its nodes ends. */
  struct ChainEnd
  {
    /** The next node of the body's boundary, round the corner. */
    std::optional<Node<2>> beyond;

    /** The boundary beyond is a line of symmetry, x_c = const, held in c. */
    std::optional<unsigned int> mirrored_component;
  };

  /**
   * Nodes of a boundary of a plane body in the order in which they follow each
   * other, with the body on the left.
   */
  struct BoundaryChain
  {
    std::vector<Node<2>>    nodes;
    bool                    is_closed = false;
    std::array<ChainEnd, 2> ends; // start and end, if it is open
  };

  /**
   * The chains that a boundary consists of.
   * @param dof_map constrained unknowns make lines of symmetry
   */
  std::vector<BoundaryChain>
  boundary_chains(const Body<2>     &body,
                  const std::string &boundary,
                  const DofMap      &dof_map);
} // namespace Signorini

#endif
