#ifndef signorini_contact_contact_process_h
#define signorini_contact_contact_process_h

#include <signorini/contact/pair_entries.h>
#include <signorini/input/entry_condition.h>

#include <memory>
#include <string>
#include <vector>

namespace dealii
{
  class ParameterHandler;
}

namespace Signorini
{
  /** What happened at one contact in a step. */
  struct ContactStep
  {
    double size;     // s
    double pressure; // at its end, Pa
    double slip;     // length of the way within it, m
  };

  /**
   * Something that goes on in a contact beside impenetrability and friction,
   * and leaves a quantity behind at each candidate: wear, heat, ageing. It may
   * move the surfaces; what it takes from the bodies by that, the contact force
   * times the way, is the energy ledger's "wear".
   *
   * One more process is one pair of files, and a line in contact_process.cc:
   * its quantity then has columns, a field of the contact surface, expected
   * results and a place in checkpoints.
   */
  class ContactProcess
  {
  public:
    struct Quantity
    {
      std::string name; // of the field, and of the column of its maximum
      std::string unit;
      std::string integral; // name of the column of its integral over the area
      std::string integral_unit;
    };

    virtual ~ContactProcess() = default;

    virtual const Quantity &
    quantity() const = 0;

    /** The quantity at the end of a step. */
    virtual double
    advance(const double old_value, const ContactStep &step) const = 0;

    /** How far the surfaces have receded, m: the gap opens by it. */
    virtual double
    recession(const double /*value*/) const
    {
      return 0.;
    }
  };

  using ContactProcesses = std::vector<std::shared_ptr<const ContactProcess>>;

  /** Declares the entries of all processes, in the section that @p prm is in.
   * @param in_pair of one pair: empty entries are those of all pairs */
  void
  declare_contact_processes(const bool in_pair, dealii::ParameterHandler &prm);

  /** Which entries are read under which choice. */
  EntryConditions
  contact_process_conditions();

  /** Those that the entries ask for. @throws InputError. */
  ContactProcesses
  parse_contact_processes(const PairEntries &entries);
} // namespace Signorini

#endif
