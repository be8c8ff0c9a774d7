#include <boost/test/unit_test.hpp>

#include "contact_setup.h"

BOOST_AUTO_TEST_SUITE(deforming_curve)

using namespace Signorini;
using namespace dealii;

namespace
{
  using Kind = SurfaceInterpolation::Kind;

  SurfaceInterpolation
  of_kind(const Kind kind)
  {
    SurfaceInterpolation interpolation;
    interpolation.kind = kind;
    return interpolation;
  }

  // A block with three elements along its lower side over one with four, whose
  // nodes do not face each other: near joints, which are rounded, gradients are
  // approximate.
  TwoBodies
  blocks(const Kind              kind,
         const unsigned int      degree,
         const ContactConstraint constraint,
         const double            gap,
         const double            angle = 0.)
  {
    const double alpha = angle * numbers::PI / 180.;
    return {turned_rectangle("0.3, 1 ; 2.55, 2", "3, 1", degree, angle),
            "bottom",
            turned_rectangle("0, 0 ; 3, 1", "4, 1", degree, angle),
            "top",
            of_kind(kind),
            constraint,
            {{-gap * std::sin(alpha), gap * std::cos(alpha)}}};
  }

  // Both blocks bent, so that their surfaces are curved.
  Vector<double>
  bent(const TwoBodies &bodies)
  {
    Vector<double> u =
      interpolate(bodies.solid, [](const Point<2> &p, const unsigned int c) {
        return 0.03 * std::sin(2. * p[0] + 3. * p[1] + c);
      });
    u += bodies.shift;
    return u;
  }

  struct Case
  {
    std::string  name;
    Kind         kind;
    unsigned int degree;
  };

  const std::vector<Case> cases = {{"spline", Kind::spline, 1},
                                   {"facets", Kind::facets, 1},
                                   {"trace of degree 1", Kind::trace, 1},
                                   {"trace of degree 2", Kind::trace, 2}};

  constexpr auto node_to_surface = ContactConstraint::node_to_surface;
  constexpr auto mortar          = ContactConstraint::mortar;

  // Sum of forces on all nodes, and their moment about a point.
  std::array<double, 3>
  resultant(const SolidModel<2>  &solid,
            const Vector<double> &u,
            const Vector<double> &forces,
            const Point<2>       &about)
  {
    std::array<double, 3> sums = {};
    for (const auto &part : solid.parts())
      for (const auto &node : part.body->nodes())
        {
          Tensor<1, 2> arm = node.point - about, force;
          for (unsigned int c = 0; c < 2; ++c)
            {
              arm[c] += u[node.dofs[c]];
              force[c] = forces[node.dofs[c]];
              sums[c] += force[c];
            }
          sums[2] += arm[0] * force[1] - arm[1] * force[0];
        }
    return sums;
  }

  // Both bodies turned about a point, after a motion u.
  Vector<double>
  turned(const SolidModel<2>  &solid,
         const Vector<double> &u,
         const double          angle)
  {
    Vector<double> result(u);
    const Point<2> centre(0.3, -0.7);
    for (const auto &part : solid.parts())
      for (const auto &node : part.body->nodes())
        {
          Tensor<1, 2> arm = node.point - centre;
          for (unsigned int c = 0; c < 2; ++c)
            arm[c] += u[node.dofs[c]];
          result[node.dofs[0]] = centre[0] + std::cos(angle) * arm[0] -
                                 std::sin(angle) * arm[1] - node.point[0];
          result[node.dofs[1]] = centre[1] + std::sin(angle) * arm[0] +
                                 std::cos(angle) * arm[1] - node.point[1];
        }
    return result;
  }

  std::string
  ring(const double       inner,
       const double       outer,
       const std::string &cells,
       const double       start,
       const unsigned int degree)
  {
    return "set Mesh = ring\nsubsection Ring\n set Inner radius = " +
           std::to_string(inner) +
           "\n set Outer radius = " + std::to_string(outer) +
           "\n set Angles = " + std::to_string(start) + ", " +
           std::to_string(start + 360.) + "\n set Cells = " + cells +
           "\nend\nset Element degree = " + std::to_string(degree) + "\n";
  }

  // The outer boundary of a ring of radius 1 in a ring of inner radius 1.02.
  TwoBodies
  rings(const Kind kind, const unsigned int degree)
  {
    return {ring(0.5, 1., "16, 1", 1.875, degree),
            "outer",
            ring(1.02, 2., "24, 1", 0., degree),
            "inner",
            of_kind(kind),
            node_to_surface};
  }
} // namespace



// G - A du is the gap after a small motion du of contactor and target, up to
// terms of second order: du = 1e-6, their factor is the curvature.
BOOST_AUTO_TEST_CASE(linearised_gaps)
{
  for (const auto &[name, kind, degree] : cases)
    BOOST_TEST_CONTEXT(name)
    {
      const auto bodies = blocks(kind, degree, node_to_surface, 0.02);
      BOOST_TEST(bodies.contact.n_contacts() == 3 * degree + 1);
      BOOST_TEST(bodies.contact.interface_dofs().size() ==
                 2 * (7 * degree + 2));
      for (const auto &point : bodies.contact.evaluate({bent(bodies), 0.}))
        BOOST_TEST(point.is_in_reach());
      BOOST_TEST(linearisation_error(bodies.contact,
                                     bodies.solid.dof_map().constraints(),
                                     bent(bodies),
                                     1e-6) < 1e-10);
      if (kind != Kind::trace)
        continue;
      const auto over = blocks(kind, degree, mortar, 0.01, 30.);
      BOOST_TEST(linearisation_error(over.contact,
                                     over.solid.dof_map().constraints(),
                                     over.shift,
                                     1e-6) < 1e-10);
    }
}



// Minus the derivative of the contact forces at fixed multipliers; central
// differences with steps of 1e-6 have an error of about 1e-9.
BOOST_AUTO_TEST_CASE(geometric_stiffness)
{
  for (const auto &[name, kind, degree] : cases)
    BOOST_TEST_CONTEXT(name)
    {
      const auto bodies = blocks(kind, degree, node_to_surface, 0.02);
      BOOST_TEST(
        stiffness_error(bodies.contact,
                        bodies.solid.dof_map().constraints(),
                        bent(bodies),
                        some_multipliers(bodies.contact.n_contacts())) < 1e-6);
    }
}



// The same for mortar, whose weights and cuts the term takes as given: exact
// for closed contact of flat surfaces.
BOOST_AUTO_TEST_CASE(geometric_stiffness_of_mortar)
{
  for (const unsigned int degree : {1u, 2u})
    for (const double angle : {0., 30.})
      BOOST_TEST_CONTEXT("degree " << degree << " at " << angle)
      {
        const auto bodies = blocks(Kind::trace, degree, mortar, 0., angle);
        BOOST_TEST(stiffness_error(bodies.contact,
                                   bodies.solid.dof_map().constraints(),
                                   bodies.shift,
                                   some_multipliers(
                                     bodies.contact.n_contacts())) < 1e-6);
      }
}



// Closed curves: gradients, stiffness, and the gap of 0.02, from which facets
// are off by up to the sagitta of 24 pieces, 1.02 (1 - cos(pi/24)).
BOOST_AUTO_TEST_CASE(ring_in_ring)
{
  std::vector<double> errors;
  for (const auto &[name, kind, degree] : cases)
    BOOST_TEST_CONTEXT(name)
    {
      const auto           bodies = rings(kind, degree);
      const Vector<double> u(bodies.solid.n_dofs());
      const auto           points = bodies.contact.evaluate({u, 0.});
      BOOST_TEST(points.size() == 16 * degree);
      errors.push_back(0.);
      for (const auto &point : points)
        errors.back() = std::max(errors.back(), std::abs(point.gap - 0.02));
      BOOST_TEST(linearisation_error(bodies.contact,
                                     bodies.solid.dof_map().constraints(),
                                     u,
                                     1e-6) < 1e-9);
      if (kind == Kind::spline || degree == 2)
        BOOST_TEST(stiffness_error(bodies.contact,
                                   bodies.solid.dof_map().constraints(),
                                   u,
                                   some_multipliers(
                                     bodies.contact.n_contacts())) < 1e-6);
    }
  const double sagitta = 1.02 * (1. - std::cos(numbers::PI / 24.));
  BOOST_TEST(errors[0] < 0.02 * sagitta); // spline
  BOOST_TEST(errors[1] < sagitta);        // facets
  BOOST_TEST(errors[1] > 0.5 * sagitta);
  BOOST_TEST(errors[2] == errors[1]); // trace of degree 1
}



// The forces of a pair are in balance: their sum is zero, and so is their
// moment, but that of friction forces apart by the gap: -tau g.
BOOST_AUTO_TEST_CASE(forces_in_balance)
{
  for (const double gap : {0., 0.02})
    for (const auto constraint : {node_to_surface, mortar})
      for (const auto &[name, kind, degree] : cases)
        BOOST_TEST_CONTEXT(name << ", gap " << gap)
        {
          if (constraint == mortar && kind != Kind::trace)
            continue;
          const auto           bodies = blocks(kind, degree, constraint, gap);
          const Vector<double> u      = gap > 0. ? bent(bodies) : bodies.shift;
          const auto           points = bodies.contact.evaluate({u, 0.});
          InterfaceForces      multipliers(
            some_multipliers(bodies.contact.n_contacts()));
          for (const bool friction : {false, true})
            {
              double moment = 0.;
              if (friction)
                for (unsigned int k = 0; k < points.size(); ++k)
                  {
                    const double tau             = 1. + std::cos(3. * k);
                    multipliers.tangential[k][0] = tau;
                    moment -= tau * points[k].gap;
                  }
              const auto sums = resultant(
                bodies.solid,
                u,
                contact_forces(bodies.contact, points, multipliers, u.size()),
                Point<2>(0.7, -0.4));
              BOOST_TEST(std::abs(sums[0]) < 1e-12);
              BOOST_TEST(std::abs(sums[1]) < 1e-12);
              BOOST_TEST(std::abs(sums[2] - moment) < 1e-12);
            }
        }
}



// A turn of both bodies together is no slip; a shift d of the contactor along
// the target is a slip d, whose sign is that of t = (-1, 0); both at once are
// d cos(angle), of second order in the angle.
BOOST_AUTO_TEST_CASE(slip)
{
  for (const auto constraint : {node_to_surface, mortar})
    for (const auto &[name, kind, degree] : cases)
      BOOST_TEST_CONTEXT(name)
      {
        if (constraint == mortar && kind != Kind::trace)
          continue;
        const auto           bodies = blocks(kind, degree, constraint, 0.);
        const Vector<double> before(bodies.solid.n_dofs());
        Vector<double>       shifted(before);
        for (const auto &node : bodies.solid.parts()[0].body->nodes())
          shifted[node.dofs[0]] = 0.013;
        const auto slips = [&](const Vector<double> &now) {
          return bodies.contact.evaluate({now, 1.}, {before, 0.});
        };
        for (const auto &point : slips(turned(bodies.solid, before, 0.3)))
          {
            BOOST_TEST(std::abs(point.gap) < 1e-13);
            BOOST_TEST(std::abs(point.slip[0]) < 1e-13);
          }
        for (const auto &point : slips(shifted))
          BOOST_TEST(std::abs(point.slip[0] + 0.013) < 1e-13);
        for (const auto &point : slips(turned(bodies.solid, shifted, 0.3)))
          BOOST_TEST(std::abs(point.slip[0] + 0.013 * std::cos(0.3)) < 1e-13);
      }
}



// A ring that is flattened until its inner boundary, an ellipse with the axes
// 1 and 0.1, nearly closes: a node sees the side opposite, not its neighbours.
BOOST_AUTO_TEST_CASE(self_contact)
{
  const auto solid =
    test_bodies<2>({ring(1., 2., "48, 1", 3., 1)}, Formulation::plane_strain);
  const auto contact = TwoBodies::create(
    solid, "inner", "inner", of_kind(Kind::spline), node_to_surface);
  const Vector<double> u =
    interpolate(solid, [](const Point<2> &p, const unsigned int c) {
      return c == 1 ? -0.9 * p[1] : 0.;
    });
  std::map<unsigned int, Point<2>> place_of_unknown;
  for (const auto &node : solid.parts()[0].body->nodes())
    for (const unsigned int dof : node.dofs)
      place_of_unknown[dof] = node.point;

  const auto   points = contact.evaluate({u, 0.});
  const auto  &nodes  = contact.pairs()[0].contactor.nodes;
  unsigned int n_seen = 0;
  for (unsigned int k = 0; k < points.size(); ++k)
    BOOST_TEST_CONTEXT("node at " << nodes[k].point)
    {
      const Point<2> x(nodes[k].point[0], 0.1 * nodes[k].point[1]);
      const bool     is_at_tip = std::abs(x[0]) > 0.8;
      BOOST_TEST((is_at_tip || points[k].is_in_reach()));
      if (!points[k].is_in_reach())
        continue;
      for (const auto &[unknown, entry] : points[k].gap_gradient)
        if (unknown != nodes[k].dofs[0] && unknown != nodes[k].dofs[1] &&
            std::abs(entry) > 1e-12)
          BOOST_TEST(place_of_unknown[unknown][1] * x[1] < 0.);
      if (is_at_tip)
        continue;
      ++n_seen;
      // The distance to the other half of the ellipse.
      double distance = 1e3;
      for (double angle = 0.; angle < numbers::PI; angle += 1e-5)
        distance = std::min(distance,
                            x.distance(Point<2>(std::cos(angle),
                                                (x[1] > 0. ? -0.1 : 0.1) *
                                                  std::sin(angle))));
      BOOST_TEST(std::abs(points[k].gap - distance) < 1e-4);
    }
  BOOST_TEST(n_seen > 20u);
  BOOST_TEST(
    linearisation_error(contact, solid.dof_map().constraints(), u, 1e-6) <
    1e-9);
  BOOST_TEST(stiffness_error(contact,
                             solid.dof_map().constraints(),
                             u,
                             some_multipliers(points.size())) < 1e-5);
}

BOOST_AUTO_TEST_SUITE_END()
