#ifndef signorini_dynamics_time_step_h
#define signorini_dynamics_time_step_h

#include <signorini/contact/contact_model.h>
#include <signorini/dynamics/contact_inertia.h>
#include <signorini/dynamics/contact_system.h>
#include <signorini/dynamics/state.h>
#include <signorini/dynamics/step_failed.h>
#include <signorini/dynamics/step_scheme.h>
#include <signorini/linear_algebra/types.h>
#include <signorini/output/timings.h>
#include <signorini/solid/solid_model.h>
#include <signorini/time/step.h>
#include <signorini/time/time_parameters.h>
#include <signorini/variational_inequality/algorithm_parameters.h>

#include <optional>
#include <string>

namespace Signorini
{
  /**
   * One step of generalized-alpha with contact: the iteration on the
   * condensed interface, doc/theory.md.
   *
   * Nodes in contact have no mass, and take part in the balance at the end of
   * the step only: their old forces carry no history, and the multiplier of the
   * interface problem is (1 - alpha_H) times their contact force. Free rigid
   * bodies, which have mass, are then integrated with the spectral radius 0, in
   * rows that are scaled for the same multiplier:
   *   M (2 A_np - A_n) = F_np + contact forces at n+1.
   */
  template <int dim>
  class TimeStep
  {
  public:
    struct Settings
    {
      TimeParameters      time;
      AlgorithmParameters algorithm;
      double              force_tolerance; // change of contact forces, 1
    };

    /** The models and the timings must outlive the object. */
    TimeStep(const SolidModel<dim>   &solid,
             const ContactModel<dim> &contact,
             const Settings          &settings,
             Timings                 &timings);

    /**
     * The state at t = 0+: loads act already, and the accelerations are those
     * that balance them. Nodes without mass move to where they are in balance.
     * @param history what all points remember
     */
    State
    initial_state(const DofVector           &displacement,
                  const DofVector           &velocity,
                  const std::vector<double> &history);

    /**
     * The state at the end of the step, which begins where the old state is.
     * @throws StepFailed; the old state is as good as before.
     */
    State
    advance(const State &old_state, const Step &step);

    /** Where active sets cycled in the last step and a globally convergent
     * method solved the interface problem: in words, or empty. */
    const std::string &
    fallbacks() const
    {
      return fallbacks_;
    }

    /** A node at which the stiffness of an iterate of the last step was not
     * positive definite: in words, or empty. */
    const std::string &
    indefinite_at() const
    {
      return indefinite_at_;
    }

    /** Where the stiffness was not positive definite in the last step because
     * a node had no mass, so that all got theirs back: in words, or empty. */
    const std::string &
    mass_given_at() const
    {
      return mass_given_at_;
    }

    /** How far loads moved free bodies as a whole before the last step, to
     * where contacts could hold them, m. */
    double
    approach() const
    {
      return approach_;
    }

    /** Largest unbalanced force over the largest force, of each iterate of the
     * last step. Newton's method squares them from one to the next. */
    const std::vector<double> &
    residuals() const
    {
      return residuals_;
    }

    /** The contact problem of the last iteration as text, if there was one. */
    void
    write_last_problem(std::ostream &stream) const
    {
      system_->write_last_problem(stream);
    }

  private:
    // The multipliers of an iterate and how they changed.
    struct Iterate
    {
      InterfaceForces   multipliers;
      std::vector<char> is_slipping;
      double            force_change; // over the largest force
      double            motion;       // largest of the correction, m
    };

    // Moves free bodies of a static run to where contacts can balance their
    // loads, free of strain, and returns a guess of the forces of these.
    InterfaceForces
    approach_contact(const double time, State &start);

    // Iterates until the state one step later is found, from forces to begin
    // with. Returns nodes with mass that come into contact in the step: then it
    // must be made without their mass, and @p state is of no use.
    std::vector<unsigned int>
    iterate(const State           &old_state,
            const Step            &step,
            const InterfaceForces &first_forces,
            State                 &state);

    // Where the iteration begins: loads, given motions, and in a static step
    // of what is not linear the way that the last one took.
    void
    begin(const State &old_state, const Step &step, State &state);

    // The last increment once more. False if there is none that would do.
    bool
    predict(const State &old_state, const Step &step, State &state);

    // Of a correction, with which `follow' begins.
    double
    first_share() const;

    // Goes along a correction as far as the bodies can follow without a
    // failure, and returns the share of it; forces go the same share.
    double
    follow(const State             &old_state,
           const double             step_size,
           const ContactCorrection &correction,
           InterfaceForces         &forces,
           State                   &state);

    SystemFactors
    effective_factors(const double step_size) const;

    std::vector<ContactPoint<dim>>
    evaluate_contact(const State &state, const State &old_state) const;

    // Internal forces, energies, history and tangent at the displacement of
    // `state'. @throws StepFailed where a material has no answer.
    void
    respond(const State &old_state, const double step_size, State &state);

    // Whether the tangent at hand is that of this state in the next step, too:
    // where the material has a history it may yield in the one and not in the
    // other.
    bool
    has_tangent_of(const State &state) const;

    // Given motions at the time of `state'.
    void
    move_supports(const State &old_state, const double step_size, State &state);

    // @throws StepFailed, or NotPositiveDefinite if the solid is linear.
    void
    factorise(const double step_size, const State &state);

    // Where K^ was not positive definite, and whether mass would help.
    void
    note_indefinite(const unsigned int unknown, const State &state);

    // Accelerations and velocities that belong to the displacement of `state`.
    void
    update_rates(const State &old_state,
                 const double step_size,
                 State       &state) const;

    void
    update_rigid_rates(const State &old_state,
                       const double step_size,
                       State       &state) const;

    void
    set_rigid_residual(const State &old_state,
                       const State &state,
                       DofVector   &residual) const;

    // Without contact forces.
    DofVector
    residual(const State &old_state, const State &state);

    // Sets state.residual: the largest unbalanced force beyond rounding over
    // the largest force.
    void
    measure_balance(const double                          step_size,
                    DofVector                             residual,
                    const std::vector<ContactPoint<dim>> &points,
                    const InterfaceForces                &multipliers,
                    State                                &state);

    // To what the forces of an iterate are known, N.
    DofVector
    force_rounding(const double step_size) const;

    // The largest force, N.
    double
    force_scale(const State &state, const InterfaceForces &multipliers) const;

    // Change of the contact forces over the largest of them. What is rounding
    // beside all forces does not count.
    double
    relative_force_change(const double           step_size,
                          const State           &state,
                          const InterfaceForces &old_multipliers,
                          const InterfaceForces &multipliers) const;

    // Why an iterate is not the end of the step yet.
    struct UnmetCriterion
    {
      std::string found;  // with its value and what is allowed
      std::string remedy; // what helps against it
    };

    std::optional<UnmetCriterion>
    unmet_criterion(const State                          &state,
                    const std::vector<ContactPoint<dim>> &points,
                    const Iterate                        &iterate) const;

    // Are forces in balance, or as far as rounding lets them be?
    bool
    is_balanced(const State &state) const;

    std::optional<UnmetCriterion>
    unmet_gap(const State                          &state,
              const std::vector<ContactPoint<dim>> &points,
              const Iterate                        &iterate) const;

    UnmetCriterion
    unmet_balance(const State &state) const;

    std::string
    failure_message(const State &state, const UnmetCriterion &unmet) const;

    // @throws StepFailed if nothing holds back the bodies of a static run.
    void
    refuse_collapse(const State &old_state, const State &state) const;

    // @throws StepFailed if a node was through a target and out again.
    void
    refuse_tunnelling(const State   &old_state,
                      const Iterate &iterate,
                      const State   &state) const;

    Iterate
    improve(const State                          &old_state,
            const double                          step_size,
            const DofVector                      &residual,
            const std::vector<ContactPoint<dim>> &points,
            const Iterate                        &iterate,
            State                                &state);

    // Where energy is kept contact forces have the directions of the middle of
    // the step, to second order those along which gaps change within it: so
    // they do no work where a contact stays closed. Empty: those of its end.
    std::vector<ContactPoint<dim>>
    acting_contacts(const std::vector<ContactPoint<dim>> &points,
                    const State                          &old_state,
                    const State                          &state) const;

    // The contact forces that the multipliers are a share of, N.
    InterfaceForces
    contact_forces(const Iterate &iterate) const;

    void
    finish(const State                          &old_state,
           const double                          step_size,
           const DofVector                      &residual,
           const std::vector<ContactPoint<dim>> &points,
           const std::vector<ContactPoint<dim>> &acting,
           const Iterate                        &iterate,
           State                                &state);

    // @throws StepFailed if the step is too long for wear.
    void
    refuse_fast_wear(const std::vector<ContactPoint<dim>> &points,
                     const State                          &state) const;

    void
    set_mean_acceleration(const State &old_state,
                          const double step_size,
                          State       &state) const;

    // Over the step, of given unknowns, N.
    DofVector
    mean_support_force(const State                          &old_state,
                       const DofVector                      &residual,
                       const std::vector<ContactPoint<dim>> &points,
                       const State                          &state) const;

    // Forces of given unknowns.
    void
    measure_supports(const std::vector<ContactPoint<dim>> &points,
                     State                                &state);

    void
    measure_motion(State &state);

    const SolidModel<dim>              &solid_;
    const ContactModel<dim>            &contact_;
    Settings                            settings_;
    Timings                            &timings_;
    StepScheme                          scheme_; // of the step
    bool                                conserves_energy_;
    ContactInertia<dim>                 inertia_;
    std::unique_ptr<ContactSystem<dim>> system_;
    double                              largest_mass_;      // of a node, kg
    double                              largest_stiffness_; // of a node, N/m
    double                              extent_;            // of all bodies, m
    bool                has_free_modes_; // static: contact holds bodies
    double              approach_;       // before the last step, m
    unsigned int        failed_step_;    // the last that failed
    std::string         fallbacks_;
    std::string         indefinite_at_;
    std::string         mass_given_at_;
    bool                lacks_mass_; // indefinite at a massless node
    std::vector<double> residuals_;

    // Absolute, of each unknown, since the step began, m: what corrections are
    // rounded against.
    DofVector largest_displacement_;
    double    rounding_multiple_; // largest residual, 1

    // Of the last iterate of a solid that is not linear.
    DofMatrix    tangent_;
    DofVector    tangent_displacement_; // where it is
    DofVector    mean_internal_force_;  // if energy is kept, N
    unsigned int section_residual_;
    unsigned int section_assembly_;
    unsigned int section_contact_;
  };
} // namespace Signorini

#endif
