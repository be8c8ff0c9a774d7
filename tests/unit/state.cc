#include <signorini/dynamics/state.h>

#include <boost/archive/text_iarchive.hpp>
#include <boost/archive/text_oarchive.hpp>
#include <boost/test/unit_test.hpp>

#include <sstream>

BOOST_AUTO_TEST_SUITE(state)

using namespace Signorini;

namespace
{
  State
  example()
  {
    State s;
    s.time       = 0.1;
    s.step       = 7;
    double value = 0.;
    for (auto *vector : {&s.displacement,
                         &s.velocity,
                         &s.acceleration,
                         &s.internal_force,
                         &s.external_force,
                         &s.support_force})
      {
        vector->reinit(3);
        for (auto &entry : *vector)
          entry = std::sqrt(value += 1.);
      }
    s.contact.forces               = InterfaceForces({0., 2.5});
    s.contact.forces.tangential[1] = {{0.5, 0.25}};
    s.contact.gaps                 = {1e-5, 0.};
    s.contact_debt                 = 1e-9;
    s.energy.initial               = 1.;
    s.energy.kinetic               = 2.;
    s.energy.stored                = 3.;
    s.energy.loads                 = 4.;
    s.energy.supports              = 5.;
    s.energy.contact               = 6.;
    s.energy.returned              = 7.;
    s.energy.damping               = 8.;
    s.energy.friction              = 0.5;
    s.energy.wear                  = 0.125;
    s.contact.slips                = {{{0., 0.}}, {{1e-3, 0.}}};
    s.contact.slip_rates           = {0., 3.};
    s.contact.slip_ways            = {0., 0.5};
    s.contact.is_slipping          = {0, 1};
    s.contact.recessions           = {0., 1e-6};
    s.contact.quantities           = {{"worn_depth", {0., 2e-6}}};
    s.n_iterations                 = 2;
    s.residual                     = 1e-12;
    s.kkt_residual                 = 1e-15;
    return s;
  }

  std::string
  text(const State &s)
  {
    std::ostringstream            stream;
    boost::archive::text_oarchive archive(stream);
    archive << s;
    return stream.str();
  }
} // namespace



// Written and read back, a state is the same to the bit.
BOOST_AUTO_TEST_CASE(round_trip)
{
  const State                   original = example();
  std::istringstream            stream(text(original));
  boost::archive::text_iarchive archive(stream);
  State                         copy;
  archive >> copy;
  BOOST_TEST(text(copy) == text(original));
  BOOST_TEST(copy.velocity[1] == original.velocity[1]);
  BOOST_TEST(copy.energy.scheme_loss() == original.energy.scheme_loss());
}



// A copy is a value of its own: a step that is cut goes back to it.
BOOST_AUTO_TEST_CASE(copies_are_independent)
{
  const State original = example();
  State       copy     = original;
  copy.displacement *= 2.;
  copy.contact.forces.normal[1] = 0.;
  BOOST_TEST(text(original) == text(example()));
}



BOOST_AUTO_TEST_CASE(ledger)
{
  BOOST_TEST(example().energy.scheme_loss() ==
             1. + 4. + 5. + 6. + 7. - 2. - 3. - 8. - 0.5 - 0.125);
}

BOOST_AUTO_TEST_SUITE_END()
