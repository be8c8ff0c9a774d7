#include <signorini/input/input_error.h>
#include <signorini/run/energy_verdict.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace Signorini
{
  namespace
  {
    // Relative to the turnover.
    constexpr double largest_gain_of_steps = 0.05;
    constexpr double largest_gain          = 0.2;
    constexpr double mentioned             = 0.01;

    double
    energy_put_in(const EnergyLedger &energy, const double largest_kinetic)
    {
      return std::max({energy.initial,
                       energy.sum(EnergyLedger::Kind::input),
                       largest_kinetic});
    }

    // Share of the turnover that the ledger leaves open; lost: positive.
    double
    open_share(const RunRecord &record, const double rounding)
    {
      const double lost = record.state.energy.scheme_loss();
      return std::abs(lost) > rounding && record.largest_energy > 0. ?
               lost / record.largest_energy :
               0.;
    }

    std::string
    share_in_words(const RunRecord &record, const double share)
    {
      std::ostringstream text;
      text.precision(3);
      text << "the energy ledger does not close: " << 100. * std::abs(share)
           << " % of the " << record.largest_energy
           << " J that went through were " << (share > 0. ? "lost" : "made")
           << " by the time integration";
      return text.str();
    }
  } // namespace



  std::string
  ledger_in_words(const EnergyLedger &energy)
  {
    using Kind = EnergyLedger::Kind;
    std::ostringstream text;
    text.precision(5);
    const auto add = [&](const Kind kind, const char *separator) {
      for (const auto &entry : EnergyLedger::entries())
        if (entry.kind == kind && energy.*entry.value != 0.)
          {
            text << separator << entry.name << ' ' << energy.*entry.value;
            separator = " + ";
          }
      return separator;
    };
    text << "energy [J]:";
    add(Kind::input, " ");
    text << " =";
    const char *const separator = add(Kind::taken, add(Kind::kept, " "));
    text << separator << "lost by the scheme " << energy.scheme_loss();
    return text.str();
  }



  double
  energy_turnover(const EnergyLedger &energy, const double largest_kinetic)
  {
    const double is_there = energy.sum(EnergyLedger::Kind::kept) +
                            energy.sum(EnergyLedger::Kind::taken);
    return std::max(energy_put_in(energy, largest_kinetic), is_there);
  }



  std::string
  gain_of_step_in_words(const State &old_state,
                        const State &state,
                        const double largest_kinetic)
  {
    constexpr unsigned int n_first_steps = 20;
    const double           made          = -state.energy.scheme_loss();
    const double           before        = -old_state.energy.scheme_loss();
    const double put_in = energy_put_in(state.energy, largest_kinetic);
    if (state.step <= n_first_steps || made <= before ||
        made <= largest_gain_of_steps * put_in)
      return "";
    std::ostringstream text;
    text << "the time integration made " << made << " J since t = 0 of "
         << put_in << " J that went in, " << made - before
         << " J of it in this step: it is too long for what moves. Smaller "
         << "steps help, or a smaller Spectral radius";
    return text.str();
  }



  std::string
  open_ledger_in_words(const RunRecord &record,
                       const bool       is_dynamic,
                       const double     rounding)
  {
    const double share = open_share(record, rounding);
    if (std::abs(share) <= mentioned)
      return "";
    return "warning: " + share_in_words(record, share) +
           (is_dynamic ? ". Smaller steps make it less; a Spectral radius "
                         "below 1 takes the energy of what is not resolved." :
            share > 0. ? ". Smaller steps make it less, unless the bodies "
                         "snapped from one equilibrium to another." :
                         ". Works are trapezoids from step to step: smaller "
                         "steps make it less.");
  }



  void
  refuse_made_energy(const RunRecord &record, const double rounding)
  {
    const double share = open_share(record, rounding);
    if (share < -largest_gain)
      throw ComputationError(
        share_in_words(record, share) +
        ". That is no success, although the run is complete. Take smaller "
        "steps.");
  }
} // namespace Signorini
