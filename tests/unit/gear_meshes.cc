#include <boost/test/unit_test.hpp>

#include "gear_errors.h"
#include "random_sets.h"

BOOST_AUTO_TEST_SUITE(gear_meshes)

using dealii::Point;
using dealii::Tensor;
using GearReference::error_of_pinion;
using GearReference::error_of_rack;
using GearReference::Gear;
using GearReference::pi;
using GearReference::pinion_lines;
using GearReference::Place;
using GearReference::rack_lines;
using GearReference::vertices_on;
using Signorini::GearTooth;
using Signorini::HalfTooth;
using Signorini::Mesh;
using Signorini::RackTooth;

namespace
{
  // The smallest sine of an angle of a cell; cells with positive ones have
  // positive Jacobians everywhere.
  double
  worst_corner(const Mesh<2> &mesh)
  {
    double smallest = 1.;
    for (const auto &cell : mesh.triangulation->active_cell_iterators())
      for (const unsigned int v : cell->vertex_indices())
        {
          const Tensor<1, 2> e = cell->vertex(v | 1u) - cell->vertex(v & ~1u);
          const Tensor<1, 2> f = cell->vertex(v | 2u) - cell->vertex(v & ~2u);
          smallest =
            std::min(smallest,
                     (e[0] * f[1] - e[1] * f[0]) / (e.norm() * f.norm()));
        }
    return smallest;
  }

  // Areas between the profile, as a polygon with very many corners, and the
  // origin (pinion), or y = 0 (rack).
  double
  area_of_profile(const HalfTooth &half, const bool is_rack)
  {
    const unsigned int n    = 10000;
    double             area = 0.;
    Point<2>           last = half.profile.at(0.).position;
    for (unsigned int i = 1; i <= n; ++i)
      {
        const Point<2> p =
          half.profile.at(half.profile.length() * i / n).position;
        area += is_rack ? (last[0] - p[0]) * (last[1] + p[1]) :
                          last[0] * p[1] - last[1] * p[0];
        last = p;
      }
    return area; // both halves
  }

  double
  exact_area(const Gear &gear, const Place &place, const bool is_rack)
  {
    if (is_rack)
      {
        const RackTooth tooth(gear.tooth);
        return place.n_modelled *
               (area_of_profile(tooth.half_tooth(), true) +
                pi * gear.tooth.module *
                  (place.back * gear.tooth.module - tooth.root_height()));
      }
    const double bore = place.bore * gear.pitch_radius();
    return place.n_modelled *
           (area_of_profile(GearTooth(gear.n_teeth, gear.tooth).half_tooth(),
                            false) -
            bore * bore * pi / gear.n_teeth);
  }

  // Angles, the enclosure by the polygon of the boundary, the area, and where
  // the vertices are, from the first mesh to two refinements.
  void
  check_mesh(const Gear &gear, const Place &place, const bool is_rack)
  {
    const std::string lines =
      is_rack ? rack_lines(gear, place) : pinion_lines(gear, place);
    const double exact = exact_area(gear, place, is_rack);
    double       first = 0.;
    BOOST_TEST_CONTEXT(lines)
    for (unsigned int n = 0; n < 3; ++n)
      {
        const Mesh<2> mesh = mesh_from<2>(refined(lines, n));
        BOOST_TEST(worst_corner(mesh) > 0.25);
        BOOST_TEST(error_of_enclosure(mesh) < 1e-11);
        BOOST_TEST((is_rack ? error_of_rack(mesh, gear, place) :
                              error_of_pinion(mesh, gear, place)) <
                   1e-14 * gear.n_teeth + 1e-13);
        const double error = std::abs(volume(mesh) / exact - 1.);
        BOOST_TEST(error < 0.02);
        if (n == 0)
          first = error;
        if (n == 2)
          BOOST_TEST(error < std::max(0.2 * first, 1e-6));
      }
  }

  Gear
  random_gear(GearReference::Random &random)
  {
    Gear  gear{random.integer(8, 80), {}};
    auto &tooth          = gear.tooth;
    tooth.module         = std::pow(10., random.between(-4., -1.));
    tooth.pressure_angle = random.between(14., 28.);
    tooth.addendum       = random.between(0.6, 1.1);
    tooth.dedendum       = random.between(1., 1.4);
    tooth.profile_shift  = random.between(-0.5, 0.9);
    tooth.fillet_radius  = random.between(0.1, 0.45);
    tooth.thinning       = random.between(0., 0.1) * tooth.module;
    if (random.integer(0, 1))
      {
        tooth.relief_length = random.between(0.1, 0.6) * tooth.module;
        tooth.relief        = random.between(0., 0.03) * tooth.relief_length;
      }
    return gear;
  }

  Place
  random_place(const Gear &gear, GearReference::Random &random)
  {
    Place place;
    place.n_modelled =
      random.integer(1, random.integer(0, 3) ? 4 : gear.n_teeth);
    place.n_modelled  = std::min(place.n_modelled, gear.n_teeth);
    place.at_pitch    = random.integer(1, place.n_modelled);
    place.right       = random.integer(0, 1);
    place.roll        = random.between(-1., 1.);
    place.pitch_point = {random.between(-1., 1.) * gear.tooth.module,
                         random.between(-1., 1.) * gear.tooth.module};
    place.bore        = random.between(0.1, 0.85);
    place.back        = random.between(0.3, 6.);
    place.cells       = random.integer(2, place.n_modelled > 4 ? 4 : 14);
    return place;
  }
} // namespace



BOOST_AUTO_TEST_CASE(names)
{
  const Gear gear{20, {}};
  Place      place;
  BOOST_TEST(
    names_of(mesh_from<2>("set Mesh = pinion\n").boundaries) ==
    "bore,end,left_1,left_2,left_3,right_1,right_2,right_3,roots,start,"
    "tips");
  BOOST_TEST(
    names_of(mesh_from<2>("set Mesh = rack\n").boundaries) ==
    "back,end,left_1,left_2,left_3,right_1,right_2,right_3,roots,start,"
    "tips");
  const Mesh<2> rack = mesh_from<2>(rack_lines(gear, place));
  check_flat(rack, "back", 3. * pi, Tensor<1, 2>({0., -1.}));
  check_flat(rack, "start", 2., Tensor<1, 2>({-1., 0.}));
  check_flat(rack, "end", 2., Tensor<1, 2>({1., 0.}));
  BOOST_TEST(names_of(rack.regions) == "body");

  // The cuts of the pinion are straight; with its teeth down, it starts at the
  // left.
  const Mesh<2> pinion = mesh_from<2>(pinion_lines(gear, place));
  for (const std::string name : {"start", "end"})
    {
      const auto   cut    = measure(pinion, name);
      const double length = GearTooth(20, gear.tooth).root_radius() - 6.;
      BOOST_TEST(std::abs(cut.area - length) < 1e-12);
      BOOST_TEST(std::abs(cut.normal.norm() - length) < 1e-12);
      BOOST_TEST((cut.normal[0] < 0.) == (name == "start"));
    }
}

// A gear with all teeth has no cuts, also where the last tooth meets the first.
BOOST_AUTO_TEST_CASE(whole_gears)
{
  std::vector<unsigned int> numbers_of_teeth = {5, 20, 31};
#ifdef DEBUG
  numbers_of_teeth = {5}; // the others take a minute
#endif
  for (const unsigned int z : numbers_of_teeth)
    {
      Gear gear{z, {}};
      gear.tooth.profile_shift = z == 5 ? 0.72 : 0.1;
      gear.tooth.addendum      = z == 5 ? 0.5 : 1.;
      Place place;
      place.n_modelled    = z;
      place.bore          = 0.3;
      place.cells         = 4;
      const Mesh<2> whole = mesh_from<2>(pinion_lines(gear, place));
      BOOST_TEST(whole.boundaries.size() == 2 * z + 3);
      BOOST_TEST(whole.boundaries.count("start") == 0u);
      for (const double roll : {0., 0.7, -2.})
        {
          place.roll = roll;
          check_mesh(gear, place, false);
        }
    }
}

BOOST_AUTO_TEST_CASE(random_pinions_and_racks)
{
  for (const bool is_rack : {false, true})
    {
      GearReference::Random random;
      unsigned int          n_valid = 0, n_refused = 0;
      while (n_valid < n_random_sets)
        {
          const Gear        gear  = random_gear(random);
          const Place       place = random_place(gear, random);
          const std::string error = error_from<2>(
            is_rack ? rack_lines(gear, place) : pinion_lines(gear, place));
          if (error.empty())
            {
              check_mesh(gear, place, is_rack);
              ++n_valid;
            }
          else
            {
              // Not every set makes a tooth; it must say so.
              BOOST_TEST(contains(error, is_rack ? "Rack / " : "Pinion / "),
                         error);
              ++n_refused;
            }
        }
      BOOST_TEST(n_refused < 100u);
    }
}

// Hanging nodes beside the flank and the root of one tooth.
BOOST_AUTO_TEST_CASE(local_refinement)
{
  Gear gear{20, {}};
  gear.tooth.module = 0.005;
  const Place       place;
  const std::string refinement =
    "set Refinements towards = right_2 : 5 ; roots : 4\n";

  const Mesh<2> pinion = mesh_from<2>(pinion_lines(gear, place) + refinement);
  BOOST_TEST(worst_corner(pinion) > 0.4);
  BOOST_TEST(error_of_pinion(pinion, gear, place) < 1e-12);
  BOOST_TEST(vertices_on(pinion, "right_2").size() >= 2u * 8u * 32u);
  const Mesh<2> rack = mesh_from<2>(rack_lines(gear, place) + refinement);
  BOOST_TEST(worst_corner(rack) > 0.4);
  BOOST_TEST(error_of_rack(rack, gear, place) < 1e-12);
}

BOOST_AUTO_TEST_SUITE_END()
