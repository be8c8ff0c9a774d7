#include <signorini/contact/archard_wear.h>
#include <signorini/contact/contact_law.h>

#include <boost/test/unit_test.hpp>

BOOST_AUTO_TEST_SUITE(contact_law)

using namespace Signorini;

namespace
{
  constexpr double specific = 1e-12; // k/H, 1/Pa

  ContactLaw
  wearing()
  {
    return {FrictionLaw(), {std::make_shared<const ArchardWear>(specific)}};
  }

  // One candidate that carries a force (N) on 0.5 m^2 and slips by (3, -4) mm.
  ContactState
  state_with(const double force)
  {
    ContactState state(1);
    state.forces.normal[0] = force;
    state.is_slipping[0]   = 1;
    state.quantities       = {{"worn_depth", {1e-6}}};
    return state;
  }

  ContactPoint<3>
  slipping_point()
  {
    ContactPoint<3> point;
    point.area = 0.5;
    point.slip = {{3e-3, -4e-3}};
    return point;
  }
} // namespace



// The depth grows with pressure and way, in whatever direction; the surfaces
// recede by it.
BOOST_AUTO_TEST_CASE(wear)
{
  ContactState state = state_with(10e6);
  wearing().advance(0.1, slipping_point(), 0, state);
  const double grown = specific * 20e6 * 5e-3;
  BOOST_TEST(std::abs(state.quantities["worn_depth"][0] - 1e-6 - grown) <
             1e-20);
  BOOST_TEST(wearing().recession(state, 0) ==
             state.quantities["worn_depth"][0]);
  BOOST_TEST(ContactLaw().recession(state, 0) == 0.);
}



// An open contact neither slips nor wears.
BOOST_AUTO_TEST_CASE(open_contact)
{
  ContactState state = state_with(0.);
  state.slips[0]     = {{1., 1.}};
  wearing().advance(0.1, slipping_point(), 0, state);
  BOOST_TEST(state.quantities["worn_depth"][0] == 1e-6);
  BOOST_TEST(state.slips[0][0] == 0.);
  BOOST_TEST(state.slip_rates[0] == 0.);
}



// Slip adds up as a vector and as a way; the rate is that of the step.
BOOST_AUTO_TEST_CASE(slip)
{
  ContactState state = state_with(1.);
  for (unsigned int step = 0; step < 2; ++step)
    ContactLaw().advance(0.1, slipping_point(), 0, state);
  BOOST_TEST(state.slips[0][0] == 6e-3, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(state.slips[0][1] == -8e-3, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(state.slip_ways[0] == 10e-3, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(state.slip_rates[0] == 0.05, boost::test_tools::tolerance(1e-12));
  state.is_slipping[0] = 0;
  ContactLaw().advance(0.1, slipping_point(), 0, state);
  BOOST_TEST(state.slip_ways[0] == 0.);
}

BOOST_AUTO_TEST_SUITE_END()
