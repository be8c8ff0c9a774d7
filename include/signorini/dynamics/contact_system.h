#ifndef signorini_dynamics_contact_system_h
#define signorini_dynamics_contact_system_h

#include <signorini/contact/contact_model.h>
#include <signorini/contact/contact_state.h>
#include <signorini/linear_algebra/types.h>
#include <signorini/output/timings.h>
#include <signorini/solid/solid_model.h>
#include <signorini/variational_inequality/algorithm_parameters.h>
#include <signorini/variational_inequality/interface_problem.h>

#include <memory>
#include <ostream>

namespace Signorini
{
  /**
   * K^ = stiffness K + mass M + damping C; the rows of rigid bodies are scaled
   * once more.
   */
  struct SystemFactors
  {
    double stiffness = 1.; // 1
    double mass      = 0.; // 1/s^2
    double damping   = 0.; // 1/s
    double rigid     = 1.; // 1

    bool
    operator==(const SystemFactors &other) const
    {
      return stiffness == other.stiffness && mass == other.mass &&
             damping == other.damping && rigid == other.rigid;
    }
  };

  /** What one iteration of a step finds. */
  struct ContactCorrection
  {
    DofVector         motion;      // of all unknowns, m
    InterfaceForces   multipliers; // of the candidates, N
    std::vector<char> is_slipping; // each candidate
    double            kkt_residual;

    // Where the algorithm met a set of contacts twice, so that a globally
    // convergent method took over.
    std::vector<unsigned int> fallback_contacts;
  };

  /**
   * The effective stiffness of a step and the contact problem that stands on
   * it: one iteration from residual to correction,
   *
   *   K^ motion = residual + contact forces,   gap + dg/dq motion >= 0, ...
   *
   * The seam between a time step and what solves it: a step asks to factorise
   * and to correct, and knows neither dense nor sparse.
   */
  template <int dim>
  class ContactSystem
  {
  public:
    virtual ~ContactSystem() = default;

    /**
     * M from now on; at first that of the solid. It must outlive its use.
     * @param is_everywhere false: there are nodes without mass
     */
    virtual void
    use_mass(const DofMatrix &mass, const bool is_everywhere) = 0;

    /**
     * Assembles and factorises K^, unless it is the one at hand.
     * @param tangent K of the present iterate; null: the constant one of a
     *                linear solid
     * @throws NotPositiveDefinite, ComputationError.
     */
    virtual void
    factorise(const SystemFactors &factors,
              const DofMatrix     *tangent = nullptr) = 0;

    /** What can move as a whole is at this displacement now, m. */
    virtual void
    place(const DofVector &displacement) = 0;

    /**
     * Solves K^ motion = residual + contact forces under the gap constraints.
     *
     * @param residual    without contact forces, N
     * @param multipliers of the last iterate: the start of the search, and the
     *                    forces of the geometric contact term
     * @param at_start    of the contacts, at the start of the step
     * @throws InterfaceError.
     */
    virtual ContactCorrection
    correct(const DofVector                      &residual,
            const std::vector<ContactPoint<dim>> &points,
            const InterfaceForces                &multipliers,
            const ContactState                   &at_start) = 0;

    /** K^-1 force, as if there were no contact. */
    virtual DofVector
    respond(const DofVector &force) = 0;

    /** True if K^ is indefinite, and was made definite by springs. */
    virtual bool
    is_indefinite() const = 0;

    /** An unknown at which K^ is not positive definite. */
    virtual unsigned int
    indefinite_unknown() const = 0;

    /** False if contacts may penetrate or creep (penalty). */
    virtual bool
    enforces_exactly() const = 0;

    /** Writes the contact problem of the last correction as text, so that it
     * can be looked at alone; nothing if there was none. */
    virtual void
    write_last_problem(std::ostream &stream) const = 0;
  };

  /**
   * The system that the algorithm asks for.
   * @param is_static what moves as a whole has no inertia that holds it back
   * The models and the timings must outlive it.
   */
  template <int dim>
  std::unique_ptr<ContactSystem<dim>>
  make_contact_system(const SolidModel<dim>     &solid,
                      const ContactModel<dim>   &contact,
                      const AlgorithmParameters &algorithm,
                      const bool                 is_static,
                      Timings                   &timings);
} // namespace Signorini

#endif
