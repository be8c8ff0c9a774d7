#include <signorini/geometry/fir_tree/fir_tree_profile.h>

#include <boost/test/unit_test.hpp>

#include <vector>

#include "fir_tree_measures.h"
#include "fir_tree_sets.h"
#include "mesh_measures.h"

BOOST_AUTO_TEST_SUITE(fir_tree_meshes)

using dealii::Point;
using dealii::Tensor;
using Signorini::FirTreeJoint;
using Signorini::Mesh;
using Signorini::ProfilePiece;

namespace
{
  const double pi = 3.14159265358979323846;

  // Half the integral of x dy - y dx along a profile, arcs included.
  double
  green(const std::vector<ProfilePiece> &profile)
  {
    double sum = 0.;
    for (const ProfilePiece &piece : profile)
      {
        const auto step = piece.end - piece.start;
        const auto from = piece.is_arc() ? piece.center : piece.start;
        sum += 0.5 * (from[0] * step[1] - from[1] * step[0]);
        if (piece.is_arc())
          sum += 0.5 * piece.radius() * piece.radius() * piece.turn * pi / 180.;
      }
    return sum;
  }

  // The profile runs down, the body is on its right. The top closes it; the
  // part of the y axis adds nothing.
  double
  exact_blade_area(const FirTreeJoint &joint, const double shank_height)
  {
    const auto     profile = blade_profile(joint, shank_height);
    const Point<2> corner  = profile[0].start;
    return -green(profile) + 0.5 * corner[0] * corner[1];
  }

  // Seen from the axis of the disc: below the rim and below the slot, less what
  // is below the bore. The profile runs counter-clockwise around the axis.
  double
  exact_disc_area(const FirTreeJoint &joint, const double bore)
  {
    const auto     profile = slot_profile(joint);
    const Point<2> corner  = profile[0].start;
    const double   sector  = pi / joint.n_blades;
    const double   slot    = std::atan2(corner[0], corner[1]);
    const double   square  = joint.rim_radius * joint.rim_radius;
    return 0.5 * square * (sector - slot) - 0.5 * bore * bore * sector +
           green(profile);
  }

  double
  length_of_boundary(const Mesh<2> &mesh)
  {
    double length = 0.;
    for (const auto &entry : mesh.boundaries)
      length += measure(mesh, entry.first).area;
    return length;
  }

  // Areas of meshes under refinement, against the exact one: the error of
  // inscribed polygons falls by four.
  void
  check_area(const std::string &lines, const double exact)
  {
    std::vector<double> errors;
    for (unsigned int n = 0; n < 4; ++n)
      errors.push_back(volume(mesh_from<2>(refined(lines, n))) - exact);
    for (unsigned int n = 1; n < errors.size(); ++n)
      BOOST_TEST(std::abs(errors[n - 1] / errors[n] - 4.) < 0.1,
                 errors[n - 1] << " " << errors[n]);
    // Without the leading term of the error almost nothing is left.
    const double limit = (4. * errors[3] - errors[2]) / 3.;
    BOOST_TEST(std::abs(limit) < 1e-8 * exact, limit / exact);
  }

  std::vector<Point<2>>
  vertices_on(const Mesh<2> &mesh, const std::string &name)
  {
    std::vector<Point<2>> points;
    for (const auto &face : mesh.triangulation->active_face_iterators())
      if (face->at_boundary() && face->boundary_id() == mesh.boundary(name))
        for (const unsigned int v : face->vertex_indices())
          points.push_back(face->vertex(v));
    return points;
  }

  double
  distance_from_piece(const Point<2> &p, const ProfilePiece &piece)
  {
    if (piece.is_arc())
      return std::abs(p.distance(piece.center) - piece.radius());
    const Tensor<1, 2> t = piece.tangent(0.), arm = p - piece.start;
    return std::abs(t[0] * arm[1] - t[1] * arm[0]);
  }
} // namespace



BOOST_AUTO_TEST_CASE(blade_root)
{
  const FirTreeJoint joint = joint_from("");
  const Mesh<2>      mesh  = mesh_from<2>(blade_lines(""));
  BOOST_TEST(names_of(mesh.boundaries) ==
             "contact_1,contact_2,contact_3,free,symmetry,top");
  BOOST_TEST(names_of(mesh.regions) == "body");
  BOOST_TEST(euler_number(mesh) == 1);
  BOOST_TEST(error_of_enclosure(mesh) < 1e-12);
  BOOST_TEST(worst_jacobian(mesh) > 0.15);

  const double a = 25. * pi / 180.;
  for (const std::string tooth : {"1", "2", "3"})
    {
      check_flat(mesh,
                 "contact_" + tooth,
                 0.003,
                 Tensor<1, 2>({std::sin(a), std::cos(a)}));
      BOOST_TEST(measure(mesh, "contact_" + tooth).n_faces == 8u);
    }
  check_flat(mesh, "top", joint.neck(1), Tensor<1, 2>({0., 1.}));
  const auto profile = blade_profile(joint, 0.012);
  check_flat(mesh,
             "symmetry",
             profile[0].start[1] - profile.back().end[1],
             Tensor<1, 2>({-1., 0.}));
  for (const Point<2> &p : vertices_on(mesh, "symmetry"))
    BOOST_TEST(p[0] == 0.);
  check_area(blade_lines(""), exact_blade_area(joint, 0.012));
}

BOOST_AUTO_TEST_CASE(disc_sector)
{
  const FirTreeJoint joint = joint_from("");
  const Mesh<2>      mesh  = mesh_from<2>(disc_lines(""));
  BOOST_TEST(names_of(mesh.boundaries) ==
             "bore,contact_1,contact_2,contact_3,free,side,symmetry");
  BOOST_TEST(euler_number(mesh) == 1);
  BOOST_TEST(error_of_enclosure(mesh) < 1e-12);
  BOOST_TEST(worst_jacobian(mesh) > 0.15);

  const double a = 25. * pi / 180., b = pi / 44.;
  for (const std::string tooth : {"1", "2", "3"})
    check_flat(mesh,
               "contact_" + tooth,
               0.003,
               Tensor<1, 2>({-std::sin(a), -std::cos(a)}));
  check_flat(mesh,
             "side",
             0.28 - 0.2,
             Tensor<1, 2>({std::cos(b), -std::sin(b)}));
  for (const Point<2> &p : vertices_on(mesh, "bore"))
    BOOST_TEST(std::abs(p.norm() - 0.2) < 1e-15);
  for (const Point<2> &p :
       vertices_on(mesh_from<2>(refined(disc_lines(""), 2)), "symmetry"))
    BOOST_TEST(p[0] == 0.);
  check_area(disc_lines(""), exact_disc_area(joint, 0.2));
}

BOOST_AUTO_TEST_CASE(flanks_match)
{
  for (const unsigned int n : {0u, 2u})
    {
      const Mesh<2> blade = mesh_from<2>(refined(blade_lines(""), n));
      const Mesh<2> disc  = mesh_from<2>(refined(disc_lines(""), n));
      for (const std::string name : {"contact_1", "contact_2", "contact_3"})
        for (const Point<2> &p : vertices_on(blade, name))
          {
            double nearest = 1.;
            for (const Point<2> &q : vertices_on(disc, name))
              nearest = std::min(nearest, p.distance(q));
            BOOST_TEST(nearest < 1e-15);
          }
    }
}

// So do the arcs, although of different radii.
BOOST_AUTO_TEST_CASE(arcs_match)
{
  const std::string arcs  = "set Contact surface = flanks and fillets\n";
  const Mesh<2>     blade = mesh_from<2>(blade_lines(arcs));
  const Mesh<2>     disc  = mesh_from<2>(disc_lines(arcs));
  for (const std::string name : {"contact_1", "contact_2", "contact_3"})
    {
      BOOST_TEST(measure(blade, name).n_faces == measure(disc, name).n_faces);
      // Parallel faces at the same angles cannot cut into each other. The
      // counterpart of a vertex is at the distance 2 (r - R) sin(angle/2), most
      // where the first fillet has turned by 65 degrees: 1.861e-4 m.
      for (const Point<2> &p : vertices_on(blade, name))
        {
          double nearest = 1.;
          for (const Point<2> &q : vertices_on(disc, name))
            nearest = std::min(nearest, p.distance(q));
          BOOST_TEST(nearest < 1.862e-4);
        }
    }
}

// After refinement each vertex of the surface is on its straight line or arc.
BOOST_AUTO_TEST_CASE(arcs_stay_arcs)
{
  const FirTreeJoint joint = joint_from("");
  for (const bool is_blade : {true, false})
    {
      const Mesh<2> mesh =
        mesh_from<2>(refined(is_blade ? blade_lines("") : disc_lines(""), 3));
      const auto profile =
        is_blade ? blade_profile(joint, 0.012) : slot_profile(joint);
      BOOST_TEST(worst_jacobian(mesh) > 0.15);
      for (const Point<2> &p : vertices_on(mesh, "free"))
        {
          double nearest = is_blade ? 1. : std::abs(p.norm() - 0.28);
          for (const ProfilePiece &piece : profile)
            nearest = std::min(nearest, distance_from_piece(p, piece));
          BOOST_TEST(nearest < 1e-15);
        }
    }
}

BOOST_AUTO_TEST_CASE(local_refinement)
{
  for (const std::string &lines : {blade_lines(""), disc_lines("")})
    {
      BOOST_TEST(worst_curved_jacobian(mesh_from<2>(lines)) > 0.1);
      const Mesh<2> mesh = mesh_from<2>(
        lines + "set Refinements towards = contact_3 : 3 : 0.001 ; free : 3\n");
      BOOST_TEST(worst_jacobian(mesh) > 0.15);
      BOOST_TEST(worst_curved_jacobian(mesh) > 0.1);
    }
}

BOOST_AUTO_TEST_CASE(full_is_two_halves)
{
  const std::string full = "set Part = full\n";
  for (const bool is_blade : {true, false})
    for (const unsigned int n : {0u, 1u})
      {
        const auto    lines = is_blade ? blade_lines : disc_lines;
        const Mesh<2> half  = mesh_from<2>(refined(lines(""), n));
        const Mesh<2> whole = mesh_from<2>(refined(lines(full), n));
        BOOST_TEST(names_of(whole.boundaries) ==
                   std::string(is_blade ? "" : "bore,") +
                     "contact_1_left,contact_1_right,contact_2_left,contact_2_"
                     "right,contact_3_left,contact_3_right,free," +
                     (is_blade ? "top" : "side_left,side_right"));
        BOOST_TEST(whole.triangulation->n_active_cells() ==
                   2u * half.triangulation->n_active_cells());
        BOOST_TEST(std::abs(volume(whole) / volume(half) - 2.) < 1e-13);
        BOOST_TEST(euler_number(whole) == 1);
        BOOST_TEST(error_of_enclosure(whole) < 1e-12);
        const double length =
          2. * (length_of_boundary(half) - measure(half, "symmetry").area);
        BOOST_TEST(std::abs(length_of_boundary(whole) / length - 1.) < 1e-12);
        for (const std::string name : {"contact_1", "contact_2", "contact_3"})
          {
            const auto right = measure(whole, name + "_right");
            const auto left  = measure(whole, name + "_left");
            BOOST_TEST(std::abs(left.normal[0] + right.normal[0]) < 1e-15);
            BOOST_TEST(std::abs(left.normal[1] - right.normal[1]) < 1e-15);
            BOOST_TEST(std::abs(left.flux - right.flux) < 1e-15);
          }
      }
}

BOOST_AUTO_TEST_CASE(contact_with_fillets)
{
  const std::string arcs = "set Contact surface = flanks and fillets\n";
  const Mesh<2>     mesh = mesh_from<2>(refined(blade_lines(arcs), 4));
  // Flank, a tip of 120 degrees, a fillet of 65 or 120 degrees.
  const double tip   = 0.0008 * 2. / 3. * pi;
  const double first = 0.003 + tip + 0.0012 * 65. / 180. * pi;
  const double other = 0.003 + tip + 0.0012 * 120. / 180. * pi;
  BOOST_TEST(std::abs(measure(mesh, "contact_1").area / first - 1.) < 1e-4);
  BOOST_TEST(std::abs(measure(mesh, "contact_3").area / other - 1.) < 1e-4);
}

BOOST_AUTO_TEST_SUITE_END()
