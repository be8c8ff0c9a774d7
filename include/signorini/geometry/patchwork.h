#ifndef signorini_geometry_patchwork_h
#define signorini_geometry_patchwork_h

#include <signorini/geometry/mesh.h>
#include <signorini/geometry/polyline.h>

#include <functional>
#include <map>
#include <utility>
#include <vector>

namespace Signorini
{
  /**
   * A structured piece of a mesh between four edges. `bottom` and `top` run
   * from `left` to `right` and have as many points as each other, so have
   * `left` and `right`, which run from `bottom` to `top`.
   */
  struct Patch
  {
    Polyline bottom, top, left, right;

    /** With this, the lines along `bottom` are arcs about the arc's centre. */
    bool             is_round = false;
    dealii::Point<2> center   = dealii::Point<2>();
  };

  /**
   * A mesh that is sewn together from patches. Patches share the edges on which
   * their points are equal to the last digit: the same polyline is handed to
   * both.
   */
  class Patchwork
  {
  public:
    void
    add(const Patch &patch);

    /**
     * Adds the patch between a surface and the straight boundary @p id opposite
     * to it, which goes from the last point of @p above to that of @p below.
     */
    void
    add_to_boundary(const Polyline                  &surface,
                    const Polyline                  &above,
                    const Polyline                  &below,
                    const dealii::types::boundary_id id);

    /** These edges belong to the boundary with this id; others have the id 0.
     */
    void
    mark_boundary(const Polyline &line, const dealii::types::boundary_id id);

    /** The edges between these points are arcs about the centre. */
    void
    mark_arc(const Polyline &line, const dealii::Point<2> &center);

    /**
     * Adds the mirror image in the y axis. Edges with the id @p seam are inside
     * then; the image of an edge with the id i gets the id image(i).
     */
    void
    mirror(const dealii::types::boundary_id      seam,
           const std::function<dealii::types::boundary_id(
             const dealii::types::boundary_id)> &image);

    /**
     * The mesh, whose boundaries do not have names yet.
     * @throws InputError if a cell has a corner that is not convex.
     */
    Mesh<2>
    create() const;

  private:
    struct MarkedBoundary
    {
      Polyline                   line;
      dealii::types::boundary_id id;
    };

    struct MarkedArc
    {
      Polyline         line;
      dealii::Point<2> center;
    };

    std::vector<Patch>          patches;
    std::vector<MarkedBoundary> boundaries;
    std::vector<MarkedArc>      arcs;
  };
} // namespace Signorini

#endif
