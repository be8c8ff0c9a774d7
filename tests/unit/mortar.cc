#include <boost/test/unit_test.hpp>

#include "contact_setup.h"

BOOST_AUTO_TEST_SUITE(mortar)

using namespace Signorini;
using namespace dealii;

namespace
{
  // Where the contact lies: the line through the origin in direction e, with
  // the target's normal n.
  struct Line
  {
    explicit Line(const double angle)
    {
      const double alpha = angle * numbers::PI / 180.;
      e                  = Point<2>(std::cos(alpha), std::sin(alpha));
      n                  = Point<2>(-std::sin(alpha), std::cos(alpha));
    }

    Tensor<1, 2> e, n;
  };

  // int N_i ds over the part of an element between a and b; the nodes are at
  // equal distances.
  std::vector<double>
  shape_integrals(const std::vector<double> &nodes,
                  const double               a,
                  const double               b)
  {
    std::vector<double> integrals(nodes.size(), 0.);
    const double        begin = std::max(a, nodes.front());
    const double        end   = std::min(b, nodes.back());
    if (begin >= end)
      return integrals;
    // Simpson's rule, exact up to the third power.
    const std::array<std::pair<double, double>, 3> rule = {
      {{begin, 1. / 6.}, {0.5 * (begin + end), 4. / 6.}, {end, 1. / 6.}}};
    for (unsigned int i = 0; i < nodes.size(); ++i)
      for (const auto &[s, weight] : rule)
        {
          double value = 1.;
          for (unsigned int j = 0; j < nodes.size(); ++j)
            if (j != i)
              value *= (s - nodes[j]) / (nodes[i] - nodes[j]);
          integrals[i] += (end - begin) * weight * value;
        }
    return integrals;
  }

  // int N_k ds over a <= s <= b, at the first unknown of each node.
  std::map<unsigned int, double>
  node_integrals(const Body<2>     &body,
                 const std::string &boundary,
                 const Line        &line,
                 const double       a,
                 const double       b)
  {
    auto nodes = body.boundary_nodes(boundary);
    std::sort(nodes.begin(), nodes.end(), [&](const auto &p, const auto &q) {
      return p.point * line.e < q.point * line.e;
    });
    const unsigned int             degree = body.scalar_fe().degree;
    std::map<unsigned int, double> integrals;
    for (unsigned int first = 0; first + degree < nodes.size(); first += degree)
      {
        std::vector<double> places;
        for (unsigned int i = 0; i <= degree; ++i)
          places.push_back(nodes[first + i].point * line.e);
        const auto of_element = shape_integrals(places, a, b);
        for (unsigned int i = 0; i <= degree; ++i)
          integrals[nodes[first + i].dofs[0]] += of_element[i];
      }
    return integrals;
  }

  struct Case
  {
    std::string  name;
    double       start, end; // of the contactor, m; the target is 0 ... 3
    unsigned int cells;      // of the contactor
    std::string  more;       // of the target
  };

  const std::vector<Case> cases = {
    {"inside", 0.4, 2.5, 3, ""},
    {"inside, fine", 0.4, 2.5, 17, ""},
    {"inside, coarse", 0.4, 2.5, 1, ""},
    {"as wide", 0., 3., 3, ""},
    {"refined target", 0.4, 2.5, 3, "set Refinements near = 1, 1 : 0.1 : 2\n"},
    {"overhang", 1.1, 4., 3, ""},
    {"fine overhang", 1.1, 4., 17, ""},
    {"overhang on both sides", -0.7, 3.6, 5, ""},
    {"a sliver", 1.1, 3.0004, 3, ""}};
} // namespace



// The forces of a constant pressure p, lambda_k = p B_k, are the consistent
// nodal forces +- int p N n ds on both sides, whatever the meshes: that is how
// the patch test is passed. B_k counts the part that has a target.
BOOST_AUTO_TEST_CASE(constant_pressure)
{
  const double pressure = 7.;
  for (const unsigned int degree : {1u, 2u})
    for (const double angle : {0., 30.})
      for (const auto &[name, start, end, cells, more] : cases)
        BOOST_TEST_CONTEXT(name << ", degree " << degree << " at " << angle)
        {
          if (!more.empty() && angle != 0.)
            continue;
          // int N_k over a part of a parabolic element may be negative, where
          // no contact force can be.
          if (degree == 2 && name.find("overhang") != std::string::npos)
            continue;
          const Line      line(angle);
          const TwoBodies bodies(
            turned_rectangle(std::to_string(start) + ", 1 ; " +
                               std::to_string(end) + ", 2",
                             std::to_string(cells) + ", 1",
                             degree,
                             angle),
            "bottom",
            turned_rectangle("0, 0 ; 3, 1", "4, 1", degree, angle) + more,
            "top",
            {SurfaceInterpolation::Kind::trace},
            ContactConstraint::mortar);
          const double a = std::max(0., start), b = std::min(3., end);
          const auto   on_contactor =
            node_integrals(*bodies.solid.parts()[0].body, "bottom", line, a, b);
          const auto on_target =
            node_integrals(*bodies.solid.parts()[1].body, "top", line, a, b);

          std::vector<double> multipliers;
          for (const auto &node : bodies.contact.pairs()[0].contactor.nodes)
            multipliers.push_back(pressure * on_contactor.at(node.dofs[0]));
          const Vector<double> u(bodies.solid.n_dofs());
          const auto           points = bodies.contact.evaluate({u, 0.});
          for (unsigned int k = 0; k < points.size(); ++k)
            if (multipliers[k] > 1e-3)
              BOOST_TEST(std::abs(points[k].gap) < 1e-14);
          const auto     forces = contact_forces(bodies.contact,
                                             points,
                                             InterfaceForces(multipliers),
                                             u.size());
          Vector<double> expected(u.size());
          for (const auto &[dof, integral] : on_contactor)
            for (unsigned int c = 0; c < 2; ++c)
              expected[dof + c] = pressure * integral * line.n[c];
          for (const auto &[dof, integral] : on_target)
            for (unsigned int c = 0; c < 2; ++c)
              expected[dof + c] = -pressure * integral * line.n[c];
          expected -= forces;
          BOOST_TEST(expected.linfty_norm() < 1e-12);
        }
}



// A gap that opens linearly along the surface is, at each node, the gap there:
// dual functions reproduce what the shape functions can represent.
BOOST_AUTO_TEST_CASE(linear_gap)
{
  for (const unsigned int degree : {1u, 2u})
    {
      const TwoBodies bodies(rectangle("0.4, 1 ; 2.5, 2", "3, 1", degree),
                             "bottom",
                             rectangle("0, 0 ; 3, 1", "4, 1", degree),
                             "top",
                             {SurfaceInterpolation::Kind::trace},
                             ContactConstraint::mortar);
      const auto     &nodes = bodies.contact.pairs()[0].contactor.nodes;
      Vector<double>  u(bodies.solid.n_dofs());
      for (const auto &node : bodies.solid.parts()[0].body->nodes())
        u[node.dofs[1]] = 0.01 + 0.02 * node.point[0];
      const auto points = bodies.contact.evaluate({u, 0.});
      for (unsigned int k = 0; k < points.size(); ++k)
        BOOST_TEST(std::abs(points[k].gap - 0.01 - 0.02 * nodes[k].point[0]) <
                   1e-13);
    }
}

BOOST_AUTO_TEST_SUITE_END()
