#ifndef signorini_geometry_mesh_h
#define signorini_geometry_mesh_h

#include <deal.II/base/types.h>
#include <deal.II/grid/tria.h>

#include <map>
#include <memory>
#include <string>

namespace Signorini
{
  /**
   * A mesh whose boundaries and regions have names. Everything that refers to
   * a part of a body (supports, loads, contact pairs) does so by these names.
   */
  template <int dim>
  struct Mesh
  {
    std::unique_ptr<dealii::Triangulation<dim>> triangulation;

    /** Name of a boundary -> the boundary id its faces carry. */
    std::map<std::string, dealii::types::boundary_id> boundaries;

    /** Name of a region -> the material id its cells carry. */
    std::map<std::string, dealii::types::material_id> regions;

    /**
     * The id of the boundary with this name.
     * @throws InputError when there is none; the message lists the names that
     * exist.
     */
    dealii::types::boundary_id
    boundary(const std::string &name) const;
  };
} // namespace Signorini

#endif
