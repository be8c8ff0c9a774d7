#ifndef signorini_solid_body_h
#define signorini_solid_body_h

#include <signorini/geometry/mesh.h>
#include <signorini/geometry/refinement_passes.h>
#include <signorini/input/entry_condition.h>
#include <signorini/input/space_time_function.h>
#include <signorini/linear_algebra/types.h>
#include <signorini/material/material.h>
#include <signorini/solid/formulation.h>

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/fe/mapping.h>

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace dealii
{
  class ParameterHandler;
}

namespace Signorini
{
  /** A node: the place in the reference position and its unknowns. */
  template <int dim>
  struct Node
  {
    dealii::Point<dim>            point;
    std::array<unsigned int, dim> dofs; // global, one a component
  };

  /**
   * One deformable body: mesh, finite elements, material. The unknowns of all
   * bodies are counted through; those of this body are the n_dofs() from
   * first_dof() on.
   */
  template <int dim>
  class Body
  {
  public:
    /**
     * Declares the entries of a section `Body NAME`, from inside it.
     * @param regions of the mesh that have a section `Material REGION`
     */
    static void
    declare_parameters(const std::vector<std::string> &regions,
                       dealii::ParameterHandler       &prm);

    /** Which entries are read under which choice. */
    static EntryConditions
    conditions();

    /**
     * Reads the section, from inside it.
     * @param base_directory where the paths of mesh files start
     * @param passes refinements beside those of the section
     * @throws InputError
     */
    Body(const std::string        &name,
         const Formulation         formulation,
         const Kinematics          kinematics,
         const std::string        &base_directory,
         const unsigned int        first_dof,
         const RefinementPasses   &passes,
         dealii::ParameterHandler &prm);

    const std::string &
    name() const
    {
      return name_;
    }

    Formulation
    formulation() const
    {
      return formulation_;
    }

    Kinematics
    kinematics() const
    {
      return kinematics_;
    }

    /** Is the change of volume the same at all points of a cell? Against
     * locking of linear elements whose volume cannot change. */
    bool
    has_mean_dilatation() const
    {
      return has_mean_dilatation_;
    }

    const Mesh<dim> &
    mesh() const
    {
      return mesh_;
    }

    /** Displacement element: dim copies of scalar_fe(). */
    const dealii::FESystem<dim> &
    fe() const
    {
      return *fe_;
    }

    const dealii::FE_Q<dim> &
    scalar_fe() const
    {
      return *scalar_fe_;
    }

    const dealii::Mapping<dim> &
    mapping() const
    {
      return *mapping_;
    }

    const dealii::DoFHandler<dim> &
    dof_handler() const
    {
      return *dof_handler_;
    }

    /** The material of the cells with this id. */
    const Material &
    material(const dealii::types::material_id id) const
    {
      const auto own = region_materials_.find(id);
      return own == region_materials_.end() ? *material_ : *own->second;
    }

    /** Its temperature at places (before the deformation) and times; null if
     * nothing is said of it. */
    const SpaceTimeFunction<dim> *
    temperature() const
    {
      return temperature_ ? &*temperature_ : nullptr;
    }

    /** Reads it from the section that @p prm is in. @throws InputError, also
     * where no material of the body expands. */
    void
    read_temperature(const Constants                &constants,
                     const dealii::ParameterHandler &prm);

    /** All materials of the body: of the regions, and that of the rest. */
    std::vector<const Material *>
    materials() const;

    /** m; 1 unless the formulation is plane. */
    double
    thickness() const
    {
      return thickness_;
    }

    /** a in C = a M + b K, 1/s. */
    double
    mass_damping() const
    {
      return mass_damping_;
    }

    /** b in C = a M + b K, s. */
    double
    stiffness_damping() const
    {
      return stiffness_damping_;
    }

    unsigned int
    first_dof() const
    {
      return first_dof_;
    }

    unsigned int
    n_dofs() const
    {
      return dof_handler_->n_dofs();
    }

    /** All nodes, in no particular order. */
    const std::vector<Node<dim>> &
    nodes() const
    {
      return nodes_;
    }

    /** The nodes on a boundary; hanging ones included. */
    std::vector<Node<dim>>
    boundary_nodes(const std::string &boundary) const;

    /**
     * The node next to a point.
     * @param entry the path of the entry that asks, for the message
     * @throws InputError when the point lies farther from it than the body's
     * smallest cell is wide.
     */
    const Node<dim> &
    node_near(const dealii::Point<dim> &point, const std::string &entry) const;

    /** The body's part of a vector over all unknowns. */
    DofVector
    extract(const DofVector &global) const;

    /** volume_factor() of this body: thickness, 2 pi r, or 1. */
    double
    volume_factor(const dealii::Point<dim> &point) const
    {
      return Signorini::volume_factor(formulation_, point, thickness_);
    }

  private:
    void
    create_region_materials(const std::string        &base_directory,
                            dealii::ParameterHandler &prm);

    void
    choose_dilatation(const dealii::ParameterHandler &prm);

    void
    distribute_dofs(const unsigned int degree);

    std::string                              name_;
    Formulation                              formulation_;
    Kinematics                               kinematics_;
    bool                                     has_mean_dilatation_;
    Mesh<dim>                                mesh_;
    std::unique_ptr<dealii::FE_Q<dim>>       scalar_fe_;
    std::unique_ptr<dealii::FESystem<dim>>   fe_;
    std::unique_ptr<dealii::Mapping<dim>>    mapping_;
    std::unique_ptr<dealii::DoFHandler<dim>> dof_handler_;
    std::unique_ptr<Material>                material_;
    std::optional<SpaceTimeFunction<dim>>    temperature_;
    std::map<dealii::types::material_id, std::unique_ptr<Material>>
                           region_materials_;
    double                 thickness_;
    double                 mass_damping_;
    double                 stiffness_damping_;
    unsigned int           first_dof_;
    std::vector<Node<dim>> nodes_;
  };
} // namespace Signorini

#endif
