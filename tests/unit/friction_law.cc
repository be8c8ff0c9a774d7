#include <signorini/contact/friction_law.h>
#include <signorini/input/input_error.h>

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <map>

BOOST_AUTO_TEST_SUITE(friction_law)

using namespace Signorini;

namespace
{
  FrictionLaw
  law(const std::string &coefficient,
      const std::string &kinetic = "",
      const std::string &limit   = "",
      const std::string &length  = "0")
  {
    const std::map<std::string, std::string> entries = {
      {"Friction coefficient", coefficient},
      {"Kinetic friction coefficient", kinetic},
      {"Slip weakening length", length},
      {"Shear stress limit", limit}};
    return FrictionLaw::parse(
      {{"mu0", 0.25}},
      {[&](const std::string &name) { return entries.at(name); },
       [](const std::string &name) { return "Contact / " + name; }});
  }

  std::string
  message(const std::string &coefficient,
          const std::string &kinetic = "",
          const std::string &limit   = "")
  {
    try
      {
        law(coefficient, kinetic, limit);
      }
    catch (const InputError &error)
      {
        return error.what();
      }
    return "";
  }
} // namespace



BOOST_AUTO_TEST_CASE(one_coefficient)
{
  BOOST_TEST(FrictionLaw().is_frictionless());
  BOOST_TEST(law("0").is_frictionless());
  BOOST_TEST(!law("0.3").is_frictionless());
  BOOST_TEST(law("0.3").is_constant());
  BOOST_TEST(law("0.3").coefficient(true, 0., 0.) == 0.3);
  BOOST_TEST(law("0.3").coefficient(false, 5., 0.) == 0.3);
  BOOST_TEST(std::isinf(law("0.3").largest_shear_stress()));
  BOOST_TEST(law("0.3", "", "2e6").largest_shear_stress() == 2e6);
}



// The kinetic coefficient is that of what slips.
BOOST_AUTO_TEST_CASE(static_and_kinetic)
{
  const FrictionLaw two = law("0.3", "0.2");
  BOOST_TEST(!two.is_constant());
  BOOST_TEST(two.coefficient(true, 0., 0.) == 0.3);
  BOOST_TEST(two.coefficient(false, 0., 0.) == 0.2);
  BOOST_TEST(two.coefficient(false, 7., 0.) == 0.2);
  BOOST_TEST(law("0.3", "0").coefficient(false, 1., 0.) == 0.);
  BOOST_TEST(!law("0.3", "0").is_frictionless());
}



// mu(v), with constants of the .prm; it is never negative.
BOOST_AUTO_TEST_CASE(coefficient_of_the_rate)
{
  const FrictionLaw falling = law("0.4", "mu0 + 0.1*exp(-v/0.5)");
  BOOST_TEST(!falling.is_constant());
  BOOST_TEST(falling.coefficient(true, 1., 0.) == 0.4);
  for (const double v : {0., 0.5, 3.})
    BOOST_TEST(std::abs(falling.coefficient(false, v, 0.) - 0.25 -
                        0.1 * std::exp(-v / 0.5)) < 1e-14);
  BOOST_TEST(law("0.4", "0.4 - v").coefficient(false, 1., 0.) == 0.);
}



BOOST_AUTO_TEST_CASE(coefficient_falls_over_a_way)
{
  const FrictionLaw weakening = law("0.3", "0.2", "", "0.01");
  BOOST_TEST(weakening.coefficient(true, 0., 0.) == 0.3);
  BOOST_TEST(std::abs(weakening.coefficient(false, 0., 0.004) - 0.26) < 1e-15);
  BOOST_TEST(weakening.coefficient(false, 0., 0.01) == 0.2);
  BOOST_TEST(weakening.coefficient(false, 0., 0.5) == 0.2);
  BOOST_TEST(law("0.3", "0.2").coefficient(false, 0., 0.) == 0.2);
}



BOOST_AUTO_TEST_CASE(refused)
{
  BOOST_TEST(message("0.3").empty());
  BOOST_TEST(
    message("-0.1").find("Contact / Friction coefficient: found -0.1") == 0u);
  BOOST_TEST(message("much").find("Contact / Friction coefficient") == 0u);
  BOOST_TEST(message("nan").find("Contact / Friction coefficient") == 0u);
  BOOST_TEST(message("0.3", "-0.1")
               .find("Contact / Kinetic friction coefficient: found -0.1") ==
             0u);
  BOOST_TEST(
    message("0.3", "0.2 + exp(w)")
      .find("Contact / Kinetic friction coefficient: the expression") == 0u);
  BOOST_TEST(
    message("0", "0.2")
      .find("Contact / Kinetic friction coefficient: found 0.2, but the "
            "Friction coefficient is zero") == 0u);
  BOOST_TEST(
    message("0.3", "", "-1").find("Contact / Shear stress limit: found -1") ==
    0u);
}

BOOST_AUTO_TEST_SUITE_END()
