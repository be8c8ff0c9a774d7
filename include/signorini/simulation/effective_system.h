#ifndef signorini_simulation_effective_system_h
#define signorini_simulation_effective_system_h

#include <signorini/contact/contact_model.h>
#include <signorini/linear_algebra/condensed_solver.h>
#include <signorini/output/timings.h>
#include <signorini/solid/solid_model.h>
#include <signorini/variational_inequality/interface_algorithm.h>
#include <signorini/variational_inequality/interface_problem.h>

#include <deal.II/lac/sparse_matrix.h>

#include <memory>

namespace Signorini
{
  /**
   * The effective stiffness of a step, factorised, and the interface problem
   * that stands on it: one iteration from residual to correction.
   */
  template <int dim>
  class EffectiveSystem
  {
  public:
    /**
     * K^ = stiffness K + mass M + damping C; the rows of lumped unknowns, such
     * as those of rigid bodies, are scaled once more.
     */
    struct Factors
    {
      double stiffness = 1.; // 1
      double mass      = 0.; // 1/s^2
      double damping   = 0.; // 1/s
      double lumped    = 1.; // 1

      bool
      operator==(const Factors &other) const
      {
        return stiffness == other.stiffness && mass == other.mass &&
               damping == other.damping && lumped == other.lumped;
      }
    };

    /** What one iteration finds. */
    struct Correction
    {
      dealii::Vector<double> motion;      // of all unknowns, m
      InterfaceForces        multipliers; // of the candidates, N
      std::vector<char>      is_slipping; // each candidate
      double                 kkt_residual;

      // Where the algorithm met a set of contacts twice, so that a globally
      // convergent method took over.
      std::vector<unsigned int> fallback_contacts;
    };

    /** The models and the timings must outlive the object. */
    EffectiveSystem(const SolidModel<dim>              &solid,
                    const ContactModel<dim>            &contact,
                    std::unique_ptr<InterfaceAlgorithm> algorithm,
                    Timings                            &timings);

    /**
     * Assembles and factorises K^, unless it is the one at hand.
     * @param tangent K of the present iterate; null: the constant one of a
     *                linear solid
     * @throws NotPositiveDefinite, ComputationError.
     */
    void
    factorise(const Factors                      &factors,
              const dealii::SparseMatrix<double> *tangent = nullptr);

    /**
     * Solves K^ motion = residual + contact forces under the gap constraints.
     *
     * @param residual    without contact forces, N
     * @param multipliers of the last iterate: the start of the search, and the
     *                    forces of the geometric contact term
     * @param coefficients of friction, of each candidate
     * @throws InterfaceError.
     */
    Correction
    correct(const dealii::Vector<double>         &residual,
            const std::vector<ContactPoint<dim>> &points,
            const InterfaceForces                &multipliers,
            const std::vector<double>            &coefficients);

    /** K^-1 force, as if there were no contact. */
    dealii::Vector<double>
    respond(const dealii::Vector<double> &force);

    const InterfaceAlgorithm &
    algorithm() const
    {
      return *algorithm_;
    }

    const InterfaceProblem &
    interface_problem() const
    {
      return problem_;
    }

  private:
    void
    pose_interface_problem(const std::vector<ContactPoint<dim>> &points,
                           const InterfaceForces                &multipliers,
                           const std::vector<double>            &coefficients,
                           dealii::Vector<double>               &reduced_force);

    // S with the geometric contact term, or without where that term would make
    // it indefinite: then the iteration is a modified Newton's.
    InterfaceStiffness
    stiffness_with_curvature(const std::vector<ContactPoint<dim>> &points,
                             const std::vector<double> &normal_forces) const;

    const SolidModel<dim>              &solid_;
    const ContactModel<dim>            &contact_;
    Timings                            &timings_;
    std::unique_ptr<InterfaceAlgorithm> algorithm_;
    std::unique_ptr<CondensedSolver>    solver_;
    dealii::SparseMatrix<double>        matrix_;
    bool                                is_factorised_;
    Factors                             factors_;
    InterfaceStiffness                  stiffness_; // without geometric term
    InterfaceProblem                    problem_;
    unsigned int                        section_factorisation_;
    unsigned int                        section_substitution_;
    unsigned int                        section_interface_;
  };
} // namespace Signorini

#endif
