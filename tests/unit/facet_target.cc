#include <signorini/contact/facet_target.h>

#include <boost/test/unit_test.hpp>

#include "contact_setup.h"

BOOST_AUTO_TEST_SUITE(facet_target)

using namespace Signorini;
using namespace dealii;

namespace
{
  std::string
  box(const std::string &corners,
      const std::string &cells,
      const unsigned int degree,
      const std::string &more = "")
  {
    return "set Mesh = box\nsubsection Box\n set Corners = " + corners +
           "\n set Cells = " + cells +
           "\nend\nset Element degree = " + std::to_string(degree) + "\n" +
           more;
  }

  // A box with 2 x 2 elements on one with 3 x 3, wider ones.
  struct Boxes
  {
    SolidModel<3>   solid;
    ContactModel<3> contact;
    Vector<double>  u;

    Boxes(const unsigned int degree, const double gap, const std::string &more)
      : solid(test_bodies<3>(
          {box("0.13, 0.21, 1 ; 0.87, 0.79, 2", "2, 2, 1", degree),
           box("0, 0, 0 ; 1, 1, 1", "3, 3, 1", degree, more)},
          Formulation::three_dimensional))
      , contact(create(solid))
      , u(solid.n_dofs())
    {
      for (const auto &node : solid.parts()[0].body->nodes())
        u[node.dofs[2]] = gap;
    }

    static ContactModel<3>
    create(const SolidModel<3> &solid)
    {
      std::vector<ContactModel<3>::PairDescription> pairs;
      pairs.push_back({solid.parts()[0].body.get(),
                       "back",
                       std::make_unique<FacetTarget>(*solid.parts()[1].body,
                                                     "front",
                                                     SurfaceInterpolation())});
      return ContactModel<3>(std::move(pairs), solid.dof_map());
    }
  };

  // Hanging nodes on the target, too: one quarter of it is refined.
  const std::vector<std::pair<unsigned int, std::string>> cases =
    {{1, ""}, {2, ""}, {1, "set Refinements near = 0, 0, 1 : 0.1 : 1\n"}};

  // Sum of forces on all nodes, and their moment about a point.
  std::pair<Tensor<1, 3>, Tensor<1, 3>>
  resultant(const Boxes &boxes, const Vector<double> &forces)
  {
    const Point<3>                        about(0.7, -0.4, 0.1);
    std::pair<Tensor<1, 3>, Tensor<1, 3>> sums;
    for (const auto &part : boxes.solid.parts())
      for (const auto &node : part.body->nodes())
        {
          Tensor<1, 3> arm = node.point - about, force;
          for (unsigned int c = 0; c < 3; ++c)
            {
              arm[c] += boxes.u[node.dofs[c]];
              force[c] = forces[node.dofs[c]];
            }
          sums.first += force;
          sums.second += cross_product_3d(arm, force);
        }
    return sums;
  }
} // namespace



// Flat faces on meshes that do not match: gaps are exact, and G - A du is the
// gap after a small motion of both up to second order.
BOOST_AUTO_TEST_CASE(flat)
{
  for (const auto &[degree, more] : cases)
    for (const double gap : {0., 0.05, -0.01})
      BOOST_TEST_CONTEXT("degree " << degree << ", gap " << gap << ", " << more)
      {
        const Boxes boxes(degree, gap, more);
        const auto  points = boxes.contact.evaluate({boxes.u, 0.});
        BOOST_TEST(points.size() == (2 * degree + 1) * (2 * degree + 1));
        for (const auto &point : points)
          {
            BOOST_TEST(std::abs(point.gap - gap) < 1e-14);
            BOOST_TEST(std::abs(point.normal[2] - 1.) < 1e-14);
            BOOST_TEST(std::abs(point.tangents[0] * point.normal) < 1e-14);
          }
        BOOST_TEST(linearisation_error(boxes.contact,
                                       boxes.solid.dof_map().constraints(),
                                       boxes.u,
                                       1e-6) < 1e-10);
      }
}



// Forces on a bumpy target turn and change their places as both bodies move;
// one node lies beside the border, where its place is held.
BOOST_AUTO_TEST_CASE(turning_forces)
{
  for (const auto &[degree, more] : cases)
    for (const double gap : {0., 0.03})
      BOOST_TEST_CONTEXT("degree " << degree << ", gap " << gap << ", " << more)
      {
        Boxes boxes(degree, gap, more);
        for (const auto &node : boxes.solid.parts()[1].body->nodes())
          for (unsigned int c = 0; c < 3; ++c)
            boxes.u[node.dofs[c]] =
              0.02 * std::sin(4. * node.point[0] - 7. * node.point[1] + c);
        for (const auto &node : boxes.solid.parts()[0].body->nodes())
          if (node.point.distance(Point<3>(0.87, 0.79, 1.)) < 1e-6)
            boxes.u[node.dofs[0]] = 0.14;
        boxes.solid.dof_map().constraints().distribute(boxes.u);
        BOOST_TEST(
          stiffness_error(boxes.contact,
                          boxes.solid.dof_map().constraints(),
                          boxes.u,
                          some_multipliers(boxes.contact.n_contacts())) < 1e-6);
      }
}



// The frame of slip does not turn with the rounding of a normal along z.
BOOST_AUTO_TEST_CASE(steady_tangents)
{
  const Boxes    boxes(1, 0., "");
  Vector<double> moved(boxes.u);
  for (unsigned int i = 0; i < moved.size(); ++i)
    moved[i] += 1e-14 * std::cos(3. * i);
  const auto points  = boxes.contact.evaluate({boxes.u, 0.});
  const auto changed = boxes.contact.evaluate({moved, 0.});
  for (unsigned int k = 0; k < points.size(); ++k)
    for (unsigned int j = 0; j < 2; ++j)
      BOOST_TEST((points[k].tangents[j] - changed[k].tangents[j]).norm() <
                 1e-12);
}



// The forces of a pair are in balance; friction forces apart by the gap make
// the moment (x - y) x force.
BOOST_AUTO_TEST_CASE(forces_in_balance)
{
  for (const auto &[degree, more] : cases)
    for (const double gap : {0., 0.05})
      {
        const Boxes     boxes(degree, gap, more);
        const auto      points = boxes.contact.evaluate({boxes.u, 0.});
        InterfaceForces multipliers(some_multipliers(points.size()));
        Tensor<1, 3>    moment;
        for (unsigned int k = 0; k < points.size(); ++k)
          {
            multipliers.tangential[k] = {{1. + std::cos(3. * k), -0.3 * k}};
            for (unsigned int j = 0; j < 2; ++j)
              moment -=
                multipliers.tangential[k][j] * points[k].gap *
                cross_product_3d(points[k].normal, points[k].tangents[j]);
          }
        const auto [force, sum] = resultant(
          boxes,
          contact_forces(boxes.contact, points, multipliers, boxes.u.size()));
        BOOST_TEST(force.norm() < 1e-12);
        BOOST_TEST((sum - moment).norm() < 1e-12);
      }
}



// A shift of the contactor along the target is the slip; a turn of both is
// none.
BOOST_AUTO_TEST_CASE(slip)
{
  const Boxes    boxes(1, 0., "");
  Vector<double> shifted(boxes.u), turned(boxes.u);
  for (const auto &node : boxes.solid.parts()[0].body->nodes())
    {
      shifted[node.dofs[0]] = 0.02;
      shifted[node.dofs[1]] = -0.03;
    }
  const double angle = 0.2;
  for (const auto &part : boxes.solid.parts())
    for (const auto &node : part.body->nodes())
      {
        const auto &x = node.point;
        turned[node.dofs[0]] =
          (std::cos(angle) - 1.) * x[0] - std::sin(angle) * x[2];
        turned[node.dofs[2]] =
          std::sin(angle) * x[0] + (std::cos(angle) - 1.) * x[2];
      }
  Tensor<1, 3> shift;
  shift[0] = 0.02;
  shift[1] = -0.03;
  for (const auto &point : boxes.contact.evaluate({shifted, 1.}, {boxes.u, 0.}))
    for (unsigned int j = 0; j < 2; ++j)
      BOOST_TEST(std::abs(point.slip[j] - shift * point.tangents[j]) < 1e-13);
  for (const auto &point : boxes.contact.evaluate({turned, 1.}, {boxes.u, 0.}))
    {
      BOOST_TEST(std::abs(point.gap) < 1e-13);
      for (unsigned int j = 0; j < 2; ++j)
        BOOST_TEST(std::abs(point.slip[j]) < 1e-13);
    }
}



// A node that flies through the face, while the face moves, too: from above,
// not from below, not beside it, and not by where it arrives.
BOOST_AUTO_TEST_CASE(passage)
{
  const Boxes    boxes(1, 0., "");
  Vector<double> moved(boxes.u);
  for (const auto &node : boxes.solid.parts()[1].body->nodes())
    moved[node.dofs[2]] = 0.5;
  const FacetTarget target(*boxes.solid.parts()[1].body,
                           "front",
                           SurfaceInterpolation());
  const auto        still  = target.place({boxes.u, 1.}, {boxes.u, 0.});
  const auto        rising = target.place({moved, 1.}, {boxes.u, 0.});
  const auto passes = [](const auto &placed, const double z, const double to) {
    return placed
      ->passed_side(Point<3>(0.4, 0.55, z),
                    Point<3>(0.41, 0.5, to),
                    std::abs(z - 1.),
                    numbers::invalid_unsigned_int)
      .has_value();
  };
  BOOST_TEST(passes(still, 1.2, 0.7));
  BOOST_TEST(!passes(still, 1.2, 1.));
  BOOST_TEST(!passes(still, 1.2, 1.1));
  BOOST_TEST(!passes(still, 0.7, 1.2));
  BOOST_TEST(passes(rising, 1.2, 1.4));
  BOOST_TEST(!passes(rising, 1.2, 1.6));
  BOOST_TEST(!still
                ->passed_side(Point<3>(1.4, 0.5, 1.2),
                              Point<3>(1.4, 0.5, 0.7),
                              0.2,
                              numbers::invalid_unsigned_int)
                .has_value());
}



// A plate seen from a ball of radius 1: gaps are off by no more than the ball
// is from its facets, and normals by far less than those of facets. From one
// mesh to the next gaps fall with h^2, normals more slowly where the mesh is
// not smooth.
BOOST_AUTO_TEST_CASE(ball)
{
  std::vector<double> gap_errors, normal_errors;
  for (const unsigned int refinements : {2u, 3u})
    {
      const auto solid =
        test_bodies<3>({"set Mesh = ball\nsubsection Ball\n"
                        " set Initial refinements = " +
                        std::to_string(refinements) + "\nend\n"},
                       Formulation::three_dimensional);
      const FacetTarget                target(*solid.parts()[0].body,
                               "rim",
                               SurfaceInterpolation());
      std::map<unsigned int, Point<3>> place_of_unknown;
      for (const auto &node : solid.parts()[0].body->nodes())
        place_of_unknown[node.dofs[0]] = node.point;
      const Vector<double> u(solid.n_dofs());
      const auto           placed = target.place({u, 0.}, {u, 0.});

      double gap_error = 0., normal_error = 0., facet_error = 0.;
      for (unsigned int i = 0; i < 1000; ++i)
        {
          Tensor<1, 3> direction;
          for (unsigned int c = 0; c < 3; ++c)
            direction[c] = std::sin(1. + 7.3 * i + 2.1 * c + i * c);
          direction /= direction.norm();
          const Point<3> x(Point<3>() + 1.05 * direction);
          const auto     found =
            placed->closest({x, {}, -direction, numbers::invalid_unsigned_int});
          BOOST_REQUIRE(found);
          gap_error = std::max(gap_error, std::abs(found->gap - 0.05));
          normal_error =
            std::max(normal_error, (found->normal - direction).norm());
          std::vector<Point<3>> corners;
          for (unsigned int a = 0; a < 4; ++a)
            corners.push_back(
              place_of_unknown[found->supporting_dofs[3 * a].first]);
          Tensor<1, 3> normal =
            cross_product_3d(corners[3] - corners[0], corners[2] - corners[1]);
          normal /= normal.norm();
          facet_error = std::max(facet_error, (normal - direction).norm());
        }
      BOOST_TEST_MESSAGE("gap " << gap_error << ", normal " << normal_error
                                << ", normal of facets " << facet_error);
      BOOST_TEST(normal_error < facet_error / 3.);
      gap_errors.push_back(gap_error);
      normal_errors.push_back(normal_error);
    }
  BOOST_TEST(gap_errors[1] < gap_errors[0] / 3.);
  BOOST_TEST(normal_errors[1] < normal_errors[0]);
}

BOOST_AUTO_TEST_SUITE_END()
