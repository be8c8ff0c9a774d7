#ifndef signorini_contact_contact_law_h
#define signorini_contact_contact_law_h

#include <signorini/contact/contact_point.h>
#include <signorini/contact/contact_process.h>
#include <signorini/contact/contact_state.h>
#include <signorini/contact/friction_law.h>

namespace Signorini
{
  /**
   * What holds in the contacts of a pair beside impenetrability: friction, and
   * the processes. It reads the state at the start of a step, and brings it to
   * its end.
   */
  class ContactLaw
  {
  public:
    ContactLaw(FrictionLaw friction = {}, ContactProcesses processes = {})
      : friction_(std::move(friction))
      , processes_(std::move(processes))
    {}

    /** @param in_pair of one pair: empty entries are those of all pairs */
    static void
    declare_parameters(const bool in_pair, dealii::ParameterHandler &prm);

    static EntryConditions
    conditions();

    /** @throws InputError. */
    static ContactLaw
    parse(const Constants &constants, const PairEntries &entries);

    const FrictionLaw &
    friction() const
    {
      return friction_;
    }

    const ContactProcesses &
    processes() const
    {
      return processes_;
    }

    /** mu of candidate k in the step that begins with this state. */
    double
    friction_coefficient(const ContactState &state, const unsigned int k) const
    {
      return friction_.coefficient(state.is_slipping[k] == 0,
                                   state.slip_rates[k],
                                   state.slip_ways[k]);
    }

    /** tau_max B, what friction is at most whatever the contact force, N. */
    double
    largest_friction(const double area) const;

    /** How far the surfaces at candidate k have receded, m. */
    double
    recession(const ContactState &state, const unsigned int k) const;

    /**
     * Slip and quantities of candidate k at the end of a step. Forces and
     * is_slipping are those of its end already, all else of its start.
     * @param step_size s
     */
    template <int dim>
    void
    advance(const double             step_size,
            const ContactPoint<dim> &point,
            const unsigned int       k,
            ContactState            &state) const;

  private:
    FrictionLaw      friction_;
    ContactProcesses processes_;
  };
} // namespace Signorini

#endif
