#ifndef signorini_solid_stress_recovery_h
#define signorini_solid_stress_recovery_h

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

    /**
     * stress_xx, ... (Cauchy, Pa; the formulation's third direction included),
     * von_mises = sqrt(3/2 s:s), maximum_shear = half the difference of the
     * extreme principal stresses, plastic_strain (equivalent).
     *
     * @param displacement of all unknowns, m
     * @param history      of the points of the body, with this displacement
     */
    std::map<std::string, dealii::Vector<double>>
    fields(const dealii::Vector<double>         &displacement,
           const dealii::ArrayView<const double> history) const;

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
