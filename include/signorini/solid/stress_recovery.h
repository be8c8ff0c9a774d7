#ifndef signorini_solid_stress_recovery_h
#define signorini_solid_stress_recovery_h

#include <signorini/linear_algebra/types.h>
#include <signorini/solid/body.h>

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/lac/vector.h>

#include <map>
#include <string>
#include <vector>

namespace Signorini
{
  /**
   * Nodal stresses and plastic strains of a body for pictures: the values at
   * the quadrature points of each cell are extrapolated to its nodes and
   * averaged over the cells that share a node.
   */
  template <int dim>
  class StressRecovery
  {
  public:
    explicit StressRecovery(const Body<dim> &body);

    /** One unknown a node; the fields below are vectors of it. */
    const dealii::DoFHandler<dim> &
    dof_handler() const
    {
      return dof_handler_;
    }

    /** Names of fields(), in the order of a list of results. */
    static const std::vector<std::string> &
    names();

    /**
     * stress_xx, ... (Cauchy, Pa; the formulation's third direction included),
     * von_mises = sqrt(3/2 s:s), principal_max and principal_min (the largest
     * and the smallest principal stress), maximum_shear = half their
     * difference, plastic_strain (equivalent).
     *
     * @param displacement of all unknowns, m
     * @param history      of the points of the body, with this displacement
     */
    std::map<std::string, dealii::Vector<double>>
    fields(const DofVector                      &displacement,
           const dealii::ArrayView<const double> history) const;

    /** The nodes on a boundary, in the count of dof_handler(). */
    dealii::IndexSet
    boundary_nodes(const std::string &boundary) const;

    /** Position of each node, in the count of dof_handler(). */
    std::vector<dealii::Point<dim>>
    points() const;

  private:
    const Body<dim>           *body_;
    dealii::DoFHandler<dim>    dof_handler_;
    dealii::FullMatrix<double> extrapolation_; // nodes x quadrature points
  };
} // namespace Signorini

#endif
