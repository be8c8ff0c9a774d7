#include <signorini/geometry/fir_tree/fir_tree_profile.h>

#include <boost/test/unit_test.hpp>

#include <array>
#include <vector>

#include "fir_tree_measures.h"
#include "fir_tree_sets.h"
#include "random_sets.h"

BOOST_AUTO_TEST_SUITE(fir_tree_entries)

using Signorini::FirTreeJoint;
using Signorini::Mesh;

BOOST_AUTO_TEST_CASE(numbers_of_cells)
{
  for (const std::string cells : {"1", "2", "3", "17"})
    {
      const std::string lines = "set Flank cells = " + cells + "\n" +
                                "set Fillet cells = " + cells + "\n" +
                                "set Tip cells = " + cells + "\n" +
                                "set Layer cells = " + cells + "\n" +
                                "set Core cells = " + cells + "\n";
      for (const Mesh<2> &mesh : {mesh_from<2>(refined(blade_lines(lines), 1)),
                                  mesh_from<2>(refined(disc_lines(lines), 1))})
        {
          BOOST_TEST(worst_jacobian(mesh) > 0.);
          BOOST_TEST(measure(mesh, "contact_2").n_faces ==
                     2u * std::stoul(cells));
          BOOST_TEST(euler_number(mesh) == 1);
        }
    }
}

BOOST_AUTO_TEST_CASE(random_joints)
{
  for (const std::string &lines : random_joint_lines(n_random_sets, 2))
    BOOST_TEST_CONTEXT(lines)
    {
      const FirTreeJoint joint = joint_from(lines);
      std::ostringstream bore;
      bore << "set Bore radius = " << 0.6 * slot_profile(joint).back().end[1]
           << "\n";
      for (unsigned int n = 0; n < 3; ++n)
        for (const Mesh<2> &mesh :
             {mesh_from<2>(refined(blade_lines(lines), n)),
              mesh_from<2>(refined(disc_lines(lines + bore.str()), n))})
          {
            BOOST_TEST(worst_jacobian(mesh) > 0.02);
            BOOST_TEST(worst_curved_jacobian(mesh) > 0.01);
            BOOST_TEST(euler_number(mesh) == 1);
            BOOST_TEST(error_of_enclosure(mesh) < 1e-10);
          }
    }
}

BOOST_AUTO_TEST_CASE(wrong_entries)
{
  const auto check = [](const std::string &mesh,
                        const std::string &section,
                        const std::string &entry,
                        const std::string &value,
                        const std::string &reason) {
    const std::string lines = "set Mesh = " + mesh + "\nsubsection " + section +
                              "\n set " + entry + " = " + value + "\nend\n";
    const std::string error = error_from<2>(lines);
    BOOST_TEST(contains(error, section + " / " + entry + " = " + value + ": "),
               lines << error);
    BOOST_TEST(contains(error, reason), lines << error);
  };
  for (const auto &[mesh, section] :
       std::vector<std::pair<std::string, std::string>>{
         {"blade root", "Blade root"}, {"disc sector", "Disc sector"}})
    {
      check(mesh, section, "Teeth", "0", "less than 1");
      check(mesh, section, "Teeth", "7", "from 1 to 6");
      check(mesh, section, "Flank length", "0", "greater than zero");
      check(mesh, section, "Contact angle", "0", "from 5 to 60");
      check(mesh, section, "Contact angle", "90", "from 5 to 60");
      check(mesh, section, "Back flank angle", "75", "from 5 to 70");
      check(mesh, section, "Back flank angle", "4.9", "from 5 to 70");
      check(mesh, section, "Taper angle", "-1", "from 0 to 30");
      check(mesh, section, "Root radius", "-1", "greater than zero");
      check(mesh, section, "Tip radius", "0", "greater than zero");
      check(mesh, section, "Bottom radius", "0.0001", "Root radius = 0.0012");
      check(mesh, section, "Bottom radius", "0.2", "half the flank length");
      check(mesh, section, "Bottom neck width", "0.002", "twice Root radius");
      check(mesh, section, "Clearance", "-1e-6", "from 0 to");
      check(mesh, section, "Clearance", "0.001", "Root radius = 0.0012");
      check(mesh, section, "Mouth depth", "0", "greater than zero");
      check(mesh, section, "Rim radius", "0.01", "the slot's mouth");
      check(mesh, section, "Rim radius", "0.02", "deeper than the disc");
      check(mesh, section, "Blades", "2", "less than 3");
      check(mesh, section, "Blades", "100", "overlap. At most");
      check(mesh, section, "Flank cells", "0", "less than 1");
      check(mesh, section, "Tip cells", "201", "from 1 to 200");
    }
  check("blade root", "Blade root", "Shank height", "0", "greater than zero");
  check("blade root", "Blade root", "Shank cells", "0", "less than 1");
  check(
    "disc sector", "Disc sector", "Bore radius", "0.26", "bottom of the slot");
  check("disc sector", "Disc sector", "Bore cells", "0", "less than 1");

  const auto error = [](const std::string &lines) {
    return error_from<2>(blade_lines(lines));
  };
  BOOST_TEST(contains(error("set Contact angle = 60\n"
                            "set Back flank angle = 65\n"),
                      "Back flank angle = 65: together with Contact angle"));
  BOOST_TEST(contains(error("set Back flank angle = 50\n"
                            "set Taper angle = 26\n"),
                      "Taper angle = 26: together with Back flank angle"));
  BOOST_TEST(contains(error("set Contact angle = 60\n"
                            "set Back flank angle = 10\n"
                            "set Flank length = 0.0005\n"),
                      "Flank length = 0.0005: the arcs of root and tip do not "
                      "fit"));
}

// What a message gives as the limit is accepted, and it is the limit.
BOOST_AUTO_TEST_CASE(limits)
{
  const auto with = [](const std::string &entry, const std::string &value) {
    return error_from<2>(disc_lines("set " + entry + " = " + value + "\n"));
  };
  const std::vector<std::array<std::string, 3>> cases = {
    {{"Blades", "100", "At most "}},
    {{"Clearance", "0.01", "from 0 to "}},
    {{"Bottom radius", "1", "Root radius = 0.0012 to "}},
    {{"Bore radius", "0.26", "greater than "}}};
  for (const auto &[entry, wrong, before] : cases)
    BOOST_TEST_CONTEXT(entry)
    {
      const std::string error = with(entry, wrong);
      const double      limit =
        std::stod(error.substr(error.find(before) + before.size()));
      std::ostringstream allowed, beyond;
      allowed << limit;
      beyond << (entry == "Blades" ? limit + 1. : 1.002 * limit);
      BOOST_TEST(with(entry, allowed.str()) == "");
      BOOST_TEST(contains(with(entry, beyond.str()), entry));
    }
}

BOOST_AUTO_TEST_SUITE_END()
