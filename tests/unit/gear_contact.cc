#include <deal.II/grid/manifold.h>

#include <boost/test/unit_test.hpp>

#include "gear_lines.h"

BOOST_AUTO_TEST_SUITE(gear_contact)

using dealii::Point;
using dealii::Tensor;
using GearReference::Gear;
using GearReference::pi;
using GearReference::pinion_lines;
using GearReference::Place;
using GearReference::rack_lines;
using GearReference::vertices_on;
using Signorini::GearTooth;
using Signorini::Mesh;

namespace
{
  // The closest point of the profile, asked from the manifold.
  Point<2>
  on_profile(const Point<2> &p, const Mesh<2> &mesh)
  {
    const std::vector<Point<2>> point  = {p};
    const std::vector<double>   weight = {1.};
    return mesh.triangulation->get_manifold(0).get_new_point(
      dealii::make_array_view(point), dealii::make_array_view(weight));
  }
} // namespace



// The law of gearing: over the whole path of contact of a pair, pinion and rack
// touch where the line of action through the pitch point says, and nowhere
// overlap.
BOOST_AUTO_TEST_CASE(contact_on_line_of_action)
{
  for (const bool right : {true, false})
    for (const unsigned int z : {20u, 12u})
      {
        Gear gear{z, {}};
        gear.tooth.module        = 0.005;
        gear.tooth.thinning      = 1e-4; // so that the other flanks are free
        gear.tooth.profile_shift = z == 20 ? 0. : 0.42;
        const double alpha = gear.alpha(), m = gear.tooth.module;
        Place        place;
        place.right       = right;
        place.pitch_point = {0.01, -0.02};

        // The way t along the line of action, outward for the rack.
        const double ra = GearTooth(z, gear.tooth).tip_radius();
        const double rb = gear.base_radius();
        const double first =
          gear.pitch_radius() * std::sin(alpha) - std::sqrt(ra * ra - rb * rb);
        const double last =
          (1. - gear.tooth.profile_shift) * m / std::sin(alpha);
        const double       pitch = pi * m * std::cos(alpha);
        const int          sign  = right ? 1 : -1;
        const Tensor<1, 2> normal({sign * std::cos(alpha), std::sin(alpha)});
        if (z == 20)
          BOOST_TEST(std::abs((last - first) / pitch - 1.769) < 5e-4);

        for (unsigned int i = 0; i <= 20; ++i)
          {
            const double way     = first + (last - first) * i / 20.;
            place.roll           = sign * way / rb;
            const Mesh<2> pinion = mesh_from<2>(pinion_lines(gear, place));
            const Mesh<2> rack   = mesh_from<2>(rack_lines(gear, place));

            // Each pair that is within the path of contact.
            for (int k = -1; k <= 1; ++k)
              {
                const double t = way + sign * k * pitch;
                if (t < first || t > last)
                  continue;
                const Point<2> contact = place.pitch_point + t * normal;
                BOOST_TEST(on_profile(contact, pinion).distance(contact) <
                           1e-10);
                BOOST_TEST(on_profile(contact, rack).distance(contact) < 1e-10);
              }

            // No vertex of the pinion is behind a straight flank, up to its
            // tip.
            for (unsigned int k = 1; k <= 3; ++k)
              for (const Point<2> &p : vertices_on(
                     pinion, (right ? "right_" : "left_") + std::to_string(k)))
                if (p[1] < place.pitch_point[1] + last * std::sin(alpha))
                  BOOST_TEST((p - place.pitch_point) * normal - way -
                               sign * (k - 2.) * pitch >
                             -1e-14);
          }
      }
}

// The roll angle turns the pinion, without slip against the rack.
BOOST_AUTO_TEST_CASE(rolling)
{
  const Gear    gear{20, {}};
  Place         place;
  const Mesh<2> pinion  = mesh_from<2>(pinion_lines(gear, place));
  const Mesh<2> rack    = mesh_from<2>(rack_lines(gear, place));
  place.roll            = 0.3;
  const Mesh<2>  turned = mesh_from<2>(pinion_lines(gear, place));
  const Mesh<2>  moved  = mesh_from<2>(rack_lines(gear, place));
  const Point<2> center(0., 10.);
  for (unsigned int v = 0; v < pinion.triangulation->n_vertices(); ++v)
    BOOST_TEST(
      (GearReference::turned(
         Point<2>(turned.triangulation->get_vertices()[v] - center), 0.3) -
       (pinion.triangulation->get_vertices()[v] - center))
        .norm() < 1e-13);
  for (unsigned int v = 0; v < rack.triangulation->n_vertices(); ++v)
    BOOST_TEST((moved.triangulation->get_vertices()[v] -
                rack.triangulation->get_vertices()[v] - Tensor<1, 2>({3., 0.}))
                 .norm() < 1e-13);
}

BOOST_AUTO_TEST_SUITE_END()
