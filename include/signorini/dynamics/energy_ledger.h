#ifndef signorini_dynamics_energy_ledger_h
#define signorini_dynamics_energy_ledger_h

#include <string>
#include <vector>

namespace Signorini
{
  /**
   * Where energy is and where it came from since t = 0, in J (2-D: with the
   * thickness). What came in equals what is kept and what was taken, up to what
   * the time integration loses,
   *
   *   initial + loads + supports + contact + heating + returned
   *     = kinetic + stored + plastic + damping + friction + wear + scheme_loss.
   *
   * One more entry is a member and a line of entries(): it then counts in the
   * balance, and has its place in the history, the summary and checkpoints.
   */
  struct EnergyLedger
  {
    double initial  = 0.; // kinetic + stored at t = 0
    double loads    = 0.; // work of the loads
    double supports = 0.; // work of prescribed motions
    double contact  = 0.; // of the contact forces, but for friction and wear
    double heating  = 0.; // work of stresses against thermal strain
    double returned = 0.; // given back for contacts that opened or closed
    double kinetic  = 0.; // 1/2 V.M V
    double stored   = 0.; // strain energy
    double plastic  = 0.; // plastic work
    double damping  = 0.; // taken by Rayleigh damping
    double friction = 0.; // taken by slip
    double wear     = 0.; // taken as worn surfaces recede

    enum class Kind
    {
      input,
      kept,
      taken
    };

    struct Entry
    {
      std::string name;
      double EnergyLedger::*value;
      Kind                  kind;
    };

    /** The one list of what the ledger has. */
    static const std::vector<Entry> &
    entries()
    {
      static const std::vector<Entry> list = {
        {"initial", &EnergyLedger::initial, Kind::input},
        {"loads", &EnergyLedger::loads, Kind::input},
        {"supports", &EnergyLedger::supports, Kind::input},
        {"contact", &EnergyLedger::contact, Kind::input},
        {"heating", &EnergyLedger::heating, Kind::input},
        {"returned", &EnergyLedger::returned, Kind::input},
        {"kinetic", &EnergyLedger::kinetic, Kind::kept},
        {"stored", &EnergyLedger::stored, Kind::kept},
        {"plastic", &EnergyLedger::plastic, Kind::kept},
        {"damping", &EnergyLedger::damping, Kind::taken},
        {"friction", &EnergyLedger::friction, Kind::taken},
        {"wear", &EnergyLedger::wear, Kind::taken}};
      return list;
    }

    /** Sum of the entries of a kind, J. */
    double
    sum(const Kind kind) const
    {
      double result = 0.;
      for (const Entry &entry : entries())
        if (entry.kind == kind)
          result += this->*entry.value;
      return result;
    }

    /** What the time integration lost; negative: made. */
    double
    scheme_loss() const
    {
      return sum(Kind::input) - sum(Kind::taken) - sum(Kind::kept);
    }

    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int /*version*/)
    {
      for (const Entry &entry : entries())
        archive &(this->*entry.value);
    }
  };
} // namespace Signorini

#endif
