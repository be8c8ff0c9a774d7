#ifndef signorini_solid_assembler_h
#define signorini_solid_assembler_h

#include <signorini/solid/body.h>

#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/sparse_matrix.h>
#include <deal.II/lac/vector.h>

namespace Signorini
{
  /**
   * Adds the tangent stiffness and the internal forces of a body at a
   * displacement,
   *   K_ab += factor int B_a^T D B_b dV,   f_a += factor int B_a^T stress dV.
   *
   * @param constraints  hanging nodes, in the counting of all unknowns; their
   *                     rows and columns are condensed
   * @param displacement of all unknowns, m
   */
  template <int dim>
  void
  add_stiffness(const Body<dim>                         &body,
                const dealii::AffineConstraints<double> &constraints,
                const dealii::Vector<double>            &displacement,
                const double                             factor,
                dealii::SparseMatrix<double>            &stiffness,
                dealii::Vector<double>                  &internal_force);

  /**
   * Adds the mass matrix of a body, M_ab += factor int rho N_a N_b dV; lumped:
   * the sum of each row of a cell goes to the diagonal.
   */
  template <int dim>
  void
  add_mass(const Body<dim>                         &body,
           const dealii::AffineConstraints<double> &constraints,
           const bool                               lump,
           const double                             factor,
           dealii::SparseMatrix<double>            &mass);
} // namespace Signorini

#endif
