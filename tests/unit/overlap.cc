#include <signorini/contact/overlap.h>

#include <boost/test/unit_test.hpp>

#include <algorithm>

#include "contact_setup.h"

BOOST_AUTO_TEST_SUITE(overlap)

using namespace Signorini;
using namespace dealii;

namespace
{
  // A block with nodes at y = 0 every 0.25 m, above a circle whose top is at a
  // height between two of them.
  struct BlockOnCircle : BodyOnTool
  {
    BlockOnCircle(const double radius, const double top)
      : BodyOnTool(
          rectangle("0, 0 ; 1, 1", "4, 4"),
          "bottom",
          "set Shape = circle\nsubsection Circle\n set Centre = 0.625, " +
            std::to_string(top - radius) +
            "\n set Radius = " + std::to_string(radius) + "\nend\n")
    {}

    std::vector<Overlap<2>>
    find(const std::vector<double> &forces = {}) const
    {
      const Vector<double>    zero(solid.n_dofs());
      const OccupiedRegion<2> body(*solid.parts()[0].body, zero);
      return find_overlaps<2>(
        {contact.pairs()[0], body, nullptr, nullptr, {zero, 0.}, forces});
    }
  };

  double
  deepest(const std::vector<Overlap<2>> &overlaps)
  {
    double depth = 0.;
    for (const auto &overlap : overlaps)
      depth = std::max(depth, overlap.depth);
    return depth;
  }
} // namespace



BOOST_AUTO_TEST_CASE(the_sagitta_is_no_overlap)
{
  // h^2/8R = 7.8 mm
  BOOST_TEST(BlockOnCircle(1., 0.007).find().empty());
  const auto deeper = BlockOnCircle(1., 0.01).find();
  BOOST_TEST(std::abs(deepest(deeper) - 0.01) < 1e-3);
  BOOST_TEST(std::abs(deeper[0].sagitta - 0.25 * 0.25 / 8.) < 1e-5);
}



BOOST_AUTO_TEST_CASE(a_small_target_is_found_wherever_it_is)
{
  // Across the surface, just below it, and in the middle of the block.
  for (const double top : {0.01, 0.05, 0.5})
    {
      const auto found = BlockOnCircle(0.01, top).find();
      BOOST_TEST(!found.empty());
      BOOST_TEST(deepest(found) <= top + 1e-12);
      BOOST_TEST(deepest(found) >= 0.5 * top);
    }
  BOOST_TEST(BlockOnCircle(0.01, -0.001).find().empty());
}



BOOST_AUTO_TEST_CASE(forces_nearby_are_seen)
{
  const BlockOnCircle setup(0.1, 0.05);
  std::vector<double> forces(setup.contact.n_contacts());
  BOOST_TEST(!setup.find(forces).at(0).is_pressed);
  forces[3] = 1.;
  BOOST_TEST(setup.find(forces).at(0).is_pressed);
}

BOOST_AUTO_TEST_SUITE_END()
