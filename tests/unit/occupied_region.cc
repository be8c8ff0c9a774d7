#include <signorini/solid/occupied_region.h>

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <random>

#include "test_body.h"

BOOST_AUTO_TEST_SUITE(occupied_region)

using namespace Signorini;
using namespace dealii;

namespace
{
  template <int dim>
  SolidModel<dim>
  block(const std::string &entries = "")
  {
    return test_model<dim>(
      (dim == 2 ? std::string("subsection Rectangle\n set Cells = 3, 2\n") :
                  std::string("subsection Box\n set Cells = 3, 2, 2\n")) +
        "end\n" + entries,
      dim == 2 ? Formulation::plane_strain : Formulation::three_dimensional);
  }

  // A unit block, moved by (1, 2, ...), against the distance from its sides.
  template <int dim>
  void
  check_depths(const std::string &entries)
  {
    const auto                model = block<dim>(entries);
    const OccupiedRegion<dim> region(
      *model.parts()[0].body,
      interpolate(model, [](const Point<dim> &, const unsigned int c) {
        return 1. + c;
      }));
    std::mt19937                           random(3);
    std::uniform_real_distribution<double> between(-0.2, 1.2);
    unsigned int                           n_inside = 0;
    for (unsigned int i = 0; i < 300; ++i)
      {
        Point<dim> place;
        double     expected = 1.;
        for (unsigned int d = 0; d < dim; ++d)
          {
            const double along = between(random);
            place[d]           = 1. + d + along;
            expected           = std::min({expected, along, 1. - along});
          }
        const auto found = region.depth(place);
        BOOST_TEST(found.has_value() == (expected > 0.));
        if (found)
          BOOST_TEST(std::abs(*found - expected) < 1e-12);
        n_inside += found.has_value();
      }
    BOOST_TEST(n_inside > 50u);
  }
} // namespace



BOOST_AUTO_TEST_CASE(depth_is_the_distance_from_the_sides)
{
  check_depths<2>("");
  check_depths<2>("set Element degree = 2\n");
  check_depths<2>("set Refinements near = 0, 0 : 0.3 : 1\n");
  check_depths<3>("");
  check_depths<3>("set Element degree = 2\n");
}



BOOST_AUTO_TEST_CASE(nearest_piece_is_that_of_all)
{
  // Squares side by side; a tree of boxes finds what all of them say.
  using Piece = SurfacePieces<3>::Piece;
  std::vector<Piece> pieces;
  for (unsigned int i = 0; i < 30; ++i)
    {
      const double x = i % 6, y = i / 6;
      pieces.push_back({Point<3>(x, y, 0.1 * x),
                        Point<3>(x + 1, y, 0.1 * x + 0.1),
                        Point<3>(x, y + 1, 0.1 * x),
                        Point<3>(x + 1, y + 1, 0.1 * x + 0.1)});
    }
  const SurfacePieces<3>                 surface(pieces);
  std::mt19937                           random(5);
  std::uniform_real_distribution<double> between(0., 1.);
  const double                           slope = std::sqrt(1.01);
  for (unsigned int i = 0; i < 100; ++i)
    {
      const Point<3> point(6. * between(random),
                           5. * between(random),
                           -1. - between(random));
      const auto [piece, distance] = surface.nearest(point);
      // Below the slope, and not beyond its upper end.
      if (point[0] > 0.5)
        BOOST_TEST(std::abs(distance - (0.1 * point[0] - point[2]) / slope) <
                   1e-12);
      BOOST_TEST(std::abs(surface.length(piece) - slope) < 1e-12);
    }
}

BOOST_AUTO_TEST_SUITE_END()
