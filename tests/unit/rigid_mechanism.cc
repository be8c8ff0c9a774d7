#include <signorini/dynamics/rigid_mechanism.h>

#include <boost/test/unit_test.hpp>

#include <numeric>

#include "contact_setup.h"

BOOST_AUTO_TEST_SUITE(rigid_mechanism)

using namespace Signorini;
using namespace dealii;

namespace
{
  struct Result
  {
    RigidMechanism<2>::Approach approach;
    double                      force; // of all contacts, N
    double                      fall;  // of the first node along y, m
  };

  // A block of 2 x 1 above the floor y = 0, or one that falls to the right.
  Result
  drop(const double gap, const std::string &traction)
  {
    const BodyOnTool setup(
      rectangle(
        "0, " + std::to_string(gap) + " ; 2, " + std::to_string(1. + gap),
        "4, 2",
        1,
        "subsection Loads\n set Traction = top: " + traction + "\nend\n"),
      "bottom",
      "set Shape = plane\nsubsection Plane\n set Normal = 0, 1\nend\n");
    const Vector<double>        at_start(setup.solid.n_dofs());
    std::vector<Vector<double>> modes;
    for (const auto &mode : setup.solid.free_modes(at_start))
      modes.push_back(mode.motion);
    const RigidMechanism<2> mechanism(setup.contact,
                                      modes,
                                      setup.solid.external_force(1., at_start));
    Result                  result{mechanism.approach({at_start, 0.}), 0., 0.};
    const auto             &forces = result.approach.forces.normal;
    result.force     = std::accumulate(forces.begin(), forces.end(), 0.);
    const auto &node = setup.solid.parts()[0].body->nodes()[0];
    result.fall      = result.approach.way[node.dofs[1]];
    return result;
  }
} // namespace



BOOST_AUTO_TEST_CASE(falls_to_the_floor)
{
  for (const double gap : {1e-6, 0.1, 30.})
    for (const std::string load : {"1e-9", "1e6"})
      {
        const Result found = drop(gap, "0 ; -" + load);
        BOOST_TEST(found.approach.is_balanced);
        BOOST_TEST(!found.approach.endless);
        BOOST_TEST(std::abs(found.fall + gap) < 1e-6);
      }
  const Result heavy = drop(0.5, "0 ; -3");
  BOOST_TEST(heavy.force == 6., boost::test_tools::tolerance(1e-9));
}



BOOST_AUTO_TEST_CASE(stays_where_it_is)
{
  // Held already, and without any load.
  BOOST_TEST(drop(0., "0 ; -1").approach.way.linfty_norm() == 0.);
  const Result idle = drop(0.1, "0 ; 0");
  BOOST_TEST(idle.approach.is_balanced);
  BOOST_TEST(idle.approach.way.linfty_norm() == 0.);
}



BOOST_AUTO_TEST_CASE(flies_away)
{
  const Result lifted = drop(0., "0 ; 1");
  BOOST_TEST(!lifted.approach.is_balanced);
  BOOST_TEST(lifted.approach.endless.has_value());
}

BOOST_AUTO_TEST_SUITE_END()
