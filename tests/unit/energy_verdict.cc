#include <signorini/input/input_error.h>
#include <signorini/run/energy_verdict.h>

#include <boost/test/unit_test.hpp>

BOOST_AUTO_TEST_SUITE(energy_verdict)

using namespace Signorini;

namespace
{
  // 100 J went in by loads; so much is kept.
  RunRecord
  record_that_keeps(const double stored)
  {
    RunRecord record;
    record.state.step          = 50;
    record.state.energy.loads  = 100.;
    record.state.energy.stored = stored;
    record.largest_energy      = energy_turnover(record.state.energy, 0.);
    return record;
  }
} // namespace



BOOST_AUTO_TEST_CASE(turnover_is_the_largest_there_was)
{
  EnergyLedger energy;
  energy.initial  = 2.;
  energy.supports = 3.;
  energy.plastic  = 4.;
  BOOST_TEST(energy_turnover(energy, 0.) == 5.);
  BOOST_TEST(energy_turnover(energy, 7.) == 7.);
  energy.friction = 6.;
  BOOST_TEST(energy_turnover(energy, 7.) == 10.);
}



BOOST_AUTO_TEST_CASE(an_open_ledger_is_named)
{
  BOOST_TEST(open_ledger_in_words(record_that_keeps(99.5), true, 0.).empty());
  const std::string lost =
    open_ledger_in_words(record_that_keeps(98.), true, 0.);
  BOOST_TEST(lost.find("2 % of the 100 J that went through were lost") !=
             std::string::npos);
  const std::string made =
    open_ledger_in_words(record_that_keeps(110.), false, 0.);
  BOOST_TEST(made.find("9.09 % of the 110 J that went through were made") !=
             std::string::npos);
  // Rounding is no error.
  BOOST_TEST(open_ledger_in_words(record_that_keeps(98.), true, 3.).empty());
}



BOOST_AUTO_TEST_CASE(a_run_that_makes_energy_is_no_success)
{
  BOOST_CHECK_NO_THROW(refuse_made_energy(record_that_keeps(120.), 0.));
  BOOST_CHECK_NO_THROW(refuse_made_energy(record_that_keeps(10.), 0.));
  BOOST_CHECK_NO_THROW(refuse_made_energy(record_that_keeps(300.), 201.));
  BOOST_CHECK_THROW(refuse_made_energy(record_that_keeps(300.), 0.),
                    ComputationError);
}



BOOST_AUTO_TEST_CASE(a_step_that_makes_energy_is_cut)
{
  const State before = record_that_keeps(104.).state;
  BOOST_TEST(
    gain_of_step_in_words(before, record_that_keeps(104.9).state, 0.).empty());
  BOOST_TEST(
    !gain_of_step_in_words(before, record_that_keeps(106.).state, 0.).empty());
  // Of a greater kinetic energy that there was.
  BOOST_TEST(
    gain_of_step_in_words(before, record_that_keeps(106.).state, 200.).empty());
  // It was made before.
  BOOST_TEST(gain_of_step_in_words(record_that_keeps(107.).state,
                                   record_that_keeps(106.).state,
                                   0.)
               .empty());
  State early = record_that_keeps(106.).state;
  early.step  = 20;
  BOOST_TEST(gain_of_step_in_words(before, early, 0.).empty());
}

BOOST_AUTO_TEST_SUITE_END()
