#ifndef signorini_geometry_mesh_generator_h
#define signorini_geometry_mesh_generator_h

#include <signorini/geometry/mesh.h>
#include <signorini/input/entry_condition.h>

#include <string>

namespace dealii
{
  class ParameterHandler;
}

namespace Signorini
{
  /**
   * Makes the mesh of a body from the entries of one subsection.
   *
   * Each generator has a static `declare_parameters` that declares its
   * subsection, and is listed under its .prm name in mesh_generator.cc.
   */
  template <int dim>
  class MeshGenerator
  {
  public:
    virtual ~MeshGenerator() = default;

    /**
     * Reads and checks the subsection. @p prm stands in the section of the
     * body, where `declare_parameters` was called.
     * @throws InputError naming the subsection and the entry.
     */
    virtual void
    parse_parameters(const dealii::ParameterHandler &prm) = 0;

    /**
     * The mesh before the refinements that all meshes have in common. Curved
     * boundaries have their manifold attached.
     * @throws InputError
     */
    virtual Mesh<dim>
    create() const = 0;
  };

  /**
   * Declares, in the current section, `Mesh` (the names of the generators for
   * this dimension), the subsection of each generator, and the entries of
   * MeshCutout and MeshRefinement.
   */
  template <int dim>
  void
  declare_mesh_parameters(dealii::ParameterHandler &prm);

  /** Which entries and subsections are read under which choice. */
  template <int dim>
  EntryConditions
  mesh_conditions();

  /**
   * Reads the entries declared by declare_mesh_parameters() and makes the mesh.
   *
   * @param prm stands in the section of the body.
   * @param base_directory names of mesh files are relative to this folder
   * (that of the .prm); empty for the current one.
   * @param formulation as in the .prm. For `axisymmetric` the mesh is checked
   * by check_axisymmetric(); other values change nothing.
   * @throws InputError
   */
  template <int dim>
  Mesh<dim>
  create_mesh(const dealii::ParameterHandler &prm,
              const std::string              &base_directory,
              const std::string              &formulation);

  /**
   * In an axisymmetric problem x is the radius: no vertex may have x < 0, and a
   * boundary called `axis` has to lie on x = 0. Both up to 1e-12 of the size of
   * the mesh.
   * @throws InputError
   */
  template <int dim>
  void
  check_axisymmetric(const Mesh<dim> &mesh);
} // namespace Signorini

#endif
