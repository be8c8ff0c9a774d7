#ifndef signorini_dynamics_condensed_contact_system_h
#define signorini_dynamics_condensed_contact_system_h

#include <signorini/dynamics/contact_system.h>
#include <signorini/dynamics/free_modes.h>
#include <signorini/linear_algebra/condensed_solver.h>
#include <signorini/linear_algebra/types.h>
#include <signorini/output/timings.h>
#include <signorini/solid/solid_model.h>
#include <signorini/variational_inequality/interface_algorithm.h>
#include <signorini/variational_inequality/interface_problem.h>
#include <signorini/variational_inequality/interface_types.h>

#include <memory>

namespace Signorini
{
  /**
   * K^ factorised by Cholesky with the unknowns of the contacts last, so that
   * the last block of the factor is the stiffness of the interface, S = L L^T:
   * dense, and of the size of the contact surfaces. On it stands the interface
   * problem, which an algorithm solves.
   */
  template <int dim>
  class CondensedContactSystem : public ContactSystem<dim>
  {
  public:
    /**
     * The models and the timings must outlive the object.
     * @param is_static what moves as a whole has no inertia that holds it back
     */
    CondensedContactSystem(const SolidModel<dim>              &solid,
                           const ContactModel<dim>            &contact,
                           std::unique_ptr<InterfaceAlgorithm> algorithm,
                           const bool                          is_static,
                           Timings                            &timings);

    void
    use_mass(const DofMatrix &mass, const bool is_everywhere) override;

    /**
     * Assembles and factorises K^, unless it is the one at hand.
     *
     * Of a static body, K may be singular, since only contact holds it: then
     * it is factorised with springs at pins, which the interface problem does
     * not have (FreeModes). It may be indefinite, since it buckles. Springs are
     * then added which resist a correction and vanish as the iteration
     * converges (proximal-point regularisation [Rockafellar1976]), at first on
     * the interface only, whose condensed stiffness is known without them, and
     * if that is not enough on all unknowns.
     * @throws NotPositiveDefinite, ComputationError.
     */
    void
    factorise(const SystemFactors &factors,
              const DofMatrix     *tangent = nullptr) override;

    void
    place(const DofVector &displacement) override;

    ContactCorrection
    correct(const DofVector                      &residual,
            const std::vector<ContactPoint<dim>> &points,
            const InterfaceForces                &multipliers,
            const ContactState                   &at_start) override;

    bool
    is_indefinite() const override
    {
      return is_indefinite_;
    }

    unsigned int
    indefinite_unknown() const override
    {
      return indefinite_unknown_;
    }

    DofVector
    respond(const DofVector &force) override;

    bool
    enforces_exactly() const override
    {
      return algorithm_->enforces_exactly();
    }

    void
    write_last_problem(std::ostream &stream) const override;

  private:
    // The KKT residual of a solution of the interface problem, which is refined
    // where rounding has left one.
    double
    residual_of_refined(InterfaceSolution &solution) const;

    using Spring = FreeModes::Spring;

    void
    pin_free_modes();

    // Adds springs, on the interface and if need be elsewhere, until the matrix
    // is positive definite, and factorises.
    void
    factorise_with_springs();

    void
    add_spring(const unsigned int trailing, const double spring);

    InterfaceSolution
    solve_interface_problem(const std::vector<ContactPoint<dim>> &points,
                            const InterfaceForces                &multipliers,
                            InterfaceVector &reduced_force);

    // The stiffness of the interface itself: without springs, and with the
    // curvature of the gaps.
    InterfaceMatrix
    interface_stiffness(const std::vector<ContactPoint<dim>> &points,
                        const InterfaceForces &multipliers) const;

    // Solves where that stiffness is not positive definite by itself.
    InterfaceSolution
    solve_with_springs(const InterfaceMatrix &stiffness,
                       const InterfaceVector &force,
                       const InterfaceForces &multipliers);

    // Springs where closed contacts hold the interface, at rest where these
    // would have it: as long as they stay closed, nothing changes.
    void
    hold_closed_contacts(const InterfaceForces &forces,
                         const InterfaceMatrix &stiffness,
                         std::vector<Spring>   &springs,
                         std::vector<double>   &rests) const;

    const SolidModel<dim>              &solid_;
    const ContactModel<dim>            &contact_;
    Timings                            &timings_;
    std::unique_ptr<InterfaceAlgorithm> algorithm_;
    const DofMatrix                    *mass_;
    bool                                may_lack_mass_;
    std::unique_ptr<CondensedSolver>    solver_;
    DofMatrix                           matrix_;
    bool                                is_factorised_;
    bool                                may_be_weak_; // static, not linear
    bool                                is_indefinite_;
    unsigned int                        indefinite_unknown_;
    double                              last_softness_; // of springs in K^, 1
    double                              weakest_pivot_; // allowed, static; or 0
    SystemFactors                       factors_;

    // The unknowns of the interface problem: those of contact, then the pins
    // that are not among them.
    std::vector<unsigned int> trailing_;
    std::vector<unsigned int> pins_;            // numbers in trailing_
    InterfaceVector           trailing_spring_; // at each of them, N/m
    std::vector<double>       mode_stiffness_;  // of what moves, N/m
    FreeModes                 free_modes_;

    InterfaceStiffness stiffness_; // with the springs
    InterfaceProblem   problem_;
    bool         has_plain_stiffness_ = false; // the problem: as factorised
    unsigned int section_factorisation_;
    unsigned int section_substitution_;
    unsigned int section_interface_;
  };
} // namespace Signorini

#endif
