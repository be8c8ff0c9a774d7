#include <boost/test/unit_test.hpp>

#include <vector>

#include "mesh_measures.h"

BOOST_AUTO_TEST_SUITE(gear_entries)

namespace
{
  struct Setting
  {
    std::string entry;
    std::string value;
  };
} // namespace



BOOST_AUTO_TEST_CASE(wrong_entries)
{
  // The last of these entries is the wrong one.
  const auto check = [](const std::string          &section,
                        const std::vector<Setting> &entries,
                        const std::string          &reason,
                        const std::string          &named = "") {
    std::string lines = std::string("set Mesh = ") +
                        (section == "Pinion" ? "pinion" : "rack") +
                        "\nsubsection " + section + "\n";
    for (const auto &[entry, value] : entries)
      lines += " set " + entry + " = " + value + "\n";
    const std::string error = error_from<2>(lines + "end\n");
    const std::string expected =
      section + " / " +
      (named.empty() ? entries.back().entry + " = " + entries.back().value :
                       named);
    BOOST_TEST(contains(error, expected + ": "), lines << error);
    BOOST_TEST(contains(error, reason), lines << error);
  };
  for (const std::string section : {"Pinion", "Rack"})
    {
      check(section, {{"Module", "0"}}, "greater than zero");
      check(section, {{"Pressure angle", "45"}}, "10 to 35");
      check(section, {{"Addendum", "-1"}}, "greater than zero");
      check(section, {{"Dedendum", "0"}}, "greater than zero");
      check(section, {{"Fillet radius", "0.01"}}, "at least 0.05");
      check(section, {{"Fillet radius", "0.5"}}, "at most 0.4719");
      check(section, {{"Tooth thinning", "-1e-6"}}, "not be negative");
      check(section, {{"Tooth thinning", "0.004"}}, "thins the teeth away");
      check(section, {{"Tip relief", "-1e-6"}}, "not be negative");
      check(section,
            {{"Tip relief", "1e-5"}, {"Tip relief length", "0"}},
            "Tip relief = 1e-5");
      check(section,
            {{"Tip relief length", "0.001"}, {"Tip relief", "2e-4"}},
            "a tenth of Tip relief length = 0.001");
      check(section,
            {{"Tip relief", "1e-5"}, {"Tip relief length", "0.03"}},
            "which is 0.0");
      check(section, {{"Modelled teeth", "0"}}, "less than 1");
      check(section, {{"Tooth at pitch point", "0"}}, "less than 1");
      check(section, {{"Tooth at pitch point", "4"}}, "Modelled teeth = 3");
      check(section, {{"Cells along a flank", "1"}}, "less than 2");
      check(section, {{"Cells along a flank", "1001"}}, "more than 1000");
    }
  check("Pinion", {{"Teeth", "4"}}, "less than 5");
  check("Pinion", {{"Modelled teeth", "21"}}, "Teeth = 20");
  check(
    "Pinion",
    {{"Teeth", "12"}},
    "undercut. With this number of teeth, the profile shift must be at least "
    "0.2982",
    "Profile shift = 0");
  check("Pinion", {{"Profile shift", "-0.2"}}, "at least -0.1698");
  check("Pinion", {{"Profile shift", "1.3"}}, "less than Dedendum = 1.25");
  check("Pinion", {{"Addendum", "1.6"}}, "pointed");
  check("Pinion", {{"Bore radius", "0"}}, "greater than zero");
  check("Pinion", {{"Bore radius", "0.043"}}, "at most 0.0425 m");
  check("Rack", {{"Addendum", "2.2"}}, "pointed");
  check("Rack", {{"Back thickness", "1e-3"}}, "quarter of Module = 0.005");
  check("Rack", {{"Teeth of the pinion", "0"}}, "less than 5");
  check("Rack",
        {{"Profile shift", "0"}, {"Dedendum", "0.3"}, {"Addendum", "0.01"}},
        "no flank");
}

// The limits that the messages tell are allowed.
BOOST_AUTO_TEST_CASE(remedies)
{
  const auto error = [](const std::string &lines) {
    return error_from<2>("set Mesh = pinion\nsubsection Pinion\n"
                         "set Bore radius = 0.02\n" +
                         lines + "end\n");
  };
  BOOST_TEST(error("set Teeth = 12\nset Profile shift = 0.2982\n") == "");
  BOOST_TEST(error("set Teeth = 12\nset Profile shift = 0.2980\n") != "");
  BOOST_TEST(error("set Profile shift = -0.1698\n") == "");
  BOOST_TEST(error("set Fillet radius = 0.4719\n") == "");
  BOOST_TEST(error("set Bore radius = 0.0425\n") == "");
}

BOOST_AUTO_TEST_SUITE_END()
