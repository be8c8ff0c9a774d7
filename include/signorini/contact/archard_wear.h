#ifndef signorini_contact_archard_wear_h
#define signorini_contact_archard_wear_h

#include <signorini/contact/contact_process.h>

namespace Signorini
{
  /**
   * Wear of both surfaces together, after Archard: the worn depth h grows with
   * the contact pressure p and the slip rate v,
   *
   *   dh/dt = k/H p v,
   *
   * and opens the gap. k is the wear coefficient (1), H the hardness of the
   * softer body (Pa). A step adds k/H p |slip| with the pressure of its end;
   * the next step sees the new depth. [Archard1953]
   */
  class ArchardWear : public ContactProcess
  {
  public:
    /** @param specific k/H, 1/Pa */
    explicit ArchardWear(const double specific)
      : specific_(specific)
    {}

    static void
    declare_parameters(const bool in_pair, dealii::ParameterHandler &prm);

    static EntryConditions
    conditions();

    /** Null if nothing wears. @throws InputError. */
    static std::unique_ptr<const ContactProcess>
    parse(const PairEntries &entries);

    const Quantity &
    quantity() const override;

    double
    advance(const double old_depth, const ContactStep &step) const override
    {
      return old_depth + specific_ * step.pressure * step.slip;
    }

    double
    recession(const double depth) const override
    {
      return depth;
    }

  private:
    double specific_;
  };
} // namespace Signorini

#endif
