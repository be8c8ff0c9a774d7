#ifndef signorini_run_energy_verdict_h
#define signorini_run_energy_verdict_h

#include <signorini/dynamics/state.h>
#include <signorini/run/run_record.h>

#include <string>

namespace Signorini
{
  /** The ledger as a line: what came in = where it is; zeros are left out. */
  std::string
  ledger_in_words(const EnergyLedger &energy);

  /**
   * What the energy ledger says about a run. Its last term, what the time
   * integration lost or made, is an error, seen beside the turnover: the
   * largest of what went in, what is kept or was taken, and the kinetic energy
   * that was there at any time; at the end the largest that it ever was. J.
   */
  double
  energy_turnover(const EnergyLedger &energy, const double largest_kinetic);

  /**
   * What is wrong in words if a step of a dynamic run makes energy, and more
   * than 5 % of the turnover was made since t = 0; else empty. Of the first
   * steps from rest neither work nor energy means much.
   */
  std::string
  gain_of_step_in_words(const State &old_state,
                        const State &state,
                        const double largest_kinetic);

  /**
   * What there is to say at the end if the ledger leaves more than 1 % of the
   * turnover open; else empty.
   * @param rounding what the energies are known to, J
   */
  std::string
  open_ledger_in_words(const RunRecord &record,
                       const bool       is_dynamic,
                       const double     rounding);

  /** @throws ComputationError if the run has made more than 20 % of the
   * turnover: it is no success then. */
  void
  refuse_made_energy(const RunRecord &record, const double rounding);
} // namespace Signorini

#endif
