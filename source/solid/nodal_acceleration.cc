#include <signorini/solid/nodal_acceleration.h>

#include <deal.II/lac/solver_cg.h>
#include <deal.II/lac/solver_control.h>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    // M on the unknowns that have mass and are solved for, and its diagonal as
    // a preconditioner.
    class FreeMass
    {
    public:
      FreeMass(const DofMatrix &mass, const DofMap &dof_map)
        : mass_(mass)
        , inverse_diagonal_(mass.m())
      {
        for (unsigned int i = 0; i < mass.m(); ++i)
          if (!dof_map.is_constrained(i) && mass.diag_element(i) > 0.)
            inverse_diagonal_[i] = 1. / mass.diag_element(i);
      }

      void restrict(DofVector &vector) const
      {
        for (unsigned int i = 0; i < vector.size(); ++i)
          if (inverse_diagonal_[i] == 0.)
            vector[i] = 0.;
      }

      void
      vmult(DofVector &result, const DofVector &vector) const
      {
        mass_.vmult(result, vector);
        restrict(result);
      }

      struct Preconditioner
      {
        void
        vmult(DofVector &result, const DofVector &vector) const
        {
          result = vector;
          result.scale(inverse_diagonal);
        }

        const DofVector &inverse_diagonal;
      };

      Preconditioner
      preconditioner() const
      {
        return {inverse_diagonal_};
      }

    private:
      const DofMatrix &mass_;
      DofVector        inverse_diagonal_; // 0: not solved for
    };
  } // namespace



  void
  accelerate(const DofMatrix &mass,
             const DofMap    &dof_map,
             const DofVector &force,
             DofVector       &acceleration)
  {
    const FreeMass matrix(mass, dof_map);
    DofVector      change(force);
    DofVector      product(force.size());
    mass.vmult(product, acceleration);
    change -= product;
    matrix.restrict(change);
    SolverControl       control(1000, 1e-14 * force.l2_norm());
    SolverCG<DofVector> solver(control);
    DofVector           correction(force.size());
    if (change.l2_norm() > control.tolerance())
      solver.solve(matrix, correction, change, matrix.preconditioner());
    acceleration += correction;
  }
} // namespace Signorini
