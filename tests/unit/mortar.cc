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

  // The share of a node of the line: from halfway to its neighbours.
  struct Share
  {
    double begin, end;
  };

  Share
  share_of(const std::vector<double> &nodes, const unsigned int k)
  {
    return {k > 0 ? 0.5 * (nodes[k - 1] + nodes[k]) : nodes[k],
            k + 1 < nodes.size() ? 0.5 * (nodes[k] + nodes[k + 1]) : nodes[k]};
  }

  struct Case
  {
    std::string  name;
    double       start, end; // of the contactor, m; the target is 0 ... 3
    unsigned int cells;      // of the contactor
    std::string  of_contactor, of_target;
  };

  const std::vector<Case> cases = {
    {"inside", 0.4, 2.5, 3, "", ""},
    {"inside, fine", 0.4, 2.5, 17, "", ""},
    {"inside, coarse", 0.4, 2.5, 1, "", ""},
    {"as wide", 0., 3., 3, "", ""},
    {"refined target",
     0.4,
     2.5,
     3,
     "",
     "set Refinements near = 1, 1 : 0.1 : 2\n"},
    {"overhang", 1.1, 4., 3, "", ""},
    {"fine overhang", 1.1, 4., 17, "", ""},
    {"overhang on both sides", -0.7, 3.6, 5, "", ""},
    {"one element for all", -0.7, 3.6, 1, "", ""},
    {"a sliver overhangs", 1.1, 3.0004, 3, "", ""},
    {"a sliver of the target", 1., 4.99998, 2, "", ""},
    {"a held node",
     0.4,
     2.5,
     3,
     "subsection Supports\n set Fixed = left: x, y\nend\n",
     ""},
    {"a held node, overhang",
     -0.7,
     3.6,
     2,
     "subsection Supports\n set Fixed = right: x, y\nend\n",
     ""}};

  TwoBodies
  blocks(const Case &example, const unsigned int degree, const double angle)
  {
    return {turned_rectangle(std::to_string(example.start) + ", 1 ; " +
                               std::to_string(example.end) + ", 2",
                             std::to_string(example.cells) + ", 1",
                             degree,
                             angle) +
              example.of_contactor,
            "bottom",
            turned_rectangle("0, 0 ; 3, 1", "4, 1", degree, angle) +
              example.of_target,
            "top",
            {SurfaceInterpolation::Kind::trace},
            ContactConstraint::mortar};
  }

  // The lower half of a disc of radius 1 that touches y = 0.
  std::string
  half_disc(const unsigned int degree)
  {
    return "set Mesh = half disc\nsubsection Half disc\n set Centre = 0, 1\n"
           " set Radius = 1\n set Flat side = top\n"
           " set Initial refinements = 3\nend\nset Element degree = " +
           std::to_string(degree) + "\n";
  }

  double
  smallest_gap(const ContactModel<2> &contact, const unsigned int n_unknowns)
  {
    const Vector<double> u(n_unknowns);
    double               smallest = 1e300;
    for (const auto &point : contact.evaluate({u, 0.}))
      smallest = std::min(smallest, point.gap);
    return smallest;
  }
} // namespace



// A constant pressure p and shear q, lambda_k = p B_k and tau_k = q B_k, give
// the consistent nodal forces +- int (p n + q e) N ds on both sides, whatever
// the meshes and wherever the target ends: that is how the patch test is
// passed. B_k counts the part that has a target.
BOOST_AUTO_TEST_CASE(constant_stress)
{
  const double pressure = 7., shear = 3.;
  for (const unsigned int degree : {1u, 2u})
    for (const double angle : {0., 30.})
      for (const Case &example : cases)
        BOOST_TEST_CONTEXT(example.name << ", degree " << degree << " at "
                                        << angle)
        {
          if (!example.of_target.empty() && angle != 0.)
            continue;
          const Line      line(angle);
          const TwoBodies bodies = blocks(example, degree, angle);
          const double    a      = std::max(0., example.start);
          const double    b      = std::min(3., example.end);
          const auto      on_contactor =
            node_integrals(*bodies.solid.parts()[0].body, "bottom", line, a, b);
          const auto on_target =
            node_integrals(*bodies.solid.parts()[1].body, "top", line, a, b);

          const Vector<double> u(bodies.solid.n_dofs());
          const auto           points = bodies.contact.evaluate({u, 0.});
          InterfaceForces      multipliers(points.size());
          double               area = 0.;
          for (unsigned int k = 0; k < points.size(); ++k)
            {
              area += points[k].area;
              multipliers.normal[k]        = pressure * points[k].area;
              multipliers.tangential[k][0] = shear * points[k].area;
              if (points[k].area > 0.)
                BOOST_TEST(std::abs(points[k].gap) < 1e-14);
            }
          BOOST_TEST(std::abs(area - (b - a)) < 1e-13);
          const auto forces =
            contact_forces(bodies.contact, points, multipliers, u.size());

          const Tensor<1, 2> stress = pressure * line.n + shear * line.e;
          Vector<double>     expected(u.size());
          for (const auto &[dof, integral] : on_contactor)
            for (unsigned int c = 0; c < 2; ++c)
              expected[dof + c] = integral * stress[c];
          for (const auto &[dof, integral] : on_target)
            for (unsigned int c = 0; c < 2; ++c)
              expected[dof + c] = -integral * stress[c];
          expected -= forces;
          BOOST_TEST(expected.linfty_norm() < 1e-12);
        }
}



// A gap that opens linearly along the surface is, for each node, the gap in the
// middle of its share; a slip alike.
BOOST_AUTO_TEST_CASE(linear_gap)
{
  for (const unsigned int degree : {1u, 2u})
    BOOST_TEST_CONTEXT("degree " << degree)
    {
      const TwoBodies bodies = blocks(cases[0], degree, 0.);
      Vector<double>  u(bodies.solid.n_dofs());
      for (const auto &node : bodies.solid.parts()[0].body->nodes())
        {
          u[node.dofs[0]] = -0.003 * node.point[0];
          u[node.dofs[1]] = 0.01 + 0.02 * node.point[0];
        }
      const auto         &nodes = bodies.contact.pairs()[0].contactor.nodes;
      std::vector<double> places;
      for (const auto &node : nodes)
        places.push_back(node.point[0]);
      std::sort(places.begin(), places.end());
      const Vector<double> before(u.size());
      const auto points = bodies.contact.evaluate({u, 1.}, {before, 0.});
      for (unsigned int k = 0; k < points.size(); ++k)
        {
          const auto [begin, end] = share_of(
            places,
            std::lower_bound(places.begin(), places.end(), nodes[k].point[0]) -
              places.begin());
          const double middle = 0.5 * (begin + end);
          BOOST_TEST(std::abs(points[k].area - (end - begin)) < 1e-14);
          BOOST_TEST(std::abs(points[k].gap - 0.01 - 0.02 * middle) < 1e-13);
          BOOST_TEST(std::abs(points[k].slip[0] - 0.003 * middle) < 1e-13);
        }
    }
}



// Where the contactor hangs down beyond the target's end it is free to: the
// gaps are those of the part that has a target.
BOOST_AUTO_TEST_CASE(drooping_overhang)
{
  for (const unsigned int degree : {1u, 2u})
    BOOST_TEST_CONTEXT("degree " << degree)
    {
      const TwoBodies bodies = blocks({"", 1.1, 4., 3, "", ""}, degree, 0.);
      Vector<double>  u(bodies.solid.n_dofs());
      for (const auto &node : bodies.solid.parts()[0].body->nodes())
        u[node.dofs[1]] = 0.01 * (3. - node.point[0]);
      unsigned int n_seen = 0;
      for (const auto &point : bodies.contact.evaluate({u, 0.}))
        if (point.is_in_reach())
          {
            ++n_seen;
            BOOST_TEST(point.gap > 0.);
          }
      BOOST_TEST(n_seen == 2 * degree + 1);
    }
}



// Surfaces that touch have no negative gap, whichever is curved: the mean of
// what is not negative is not. At the lowest node of the disc, with neighbours
// at the distance l, it is that of x^2/2 over |x| < l/2 for a radius of 1, or
// of |x| l/2 between nodes that are joined by straight lines.
BOOST_AUTO_TEST_CASE(no_false_overclosure)
{
  const std::string circle = "set Shape = circle\nsubsection Circle\n"
                             " set Centre = 0.93, -0.5\n set Radius = 0.5\n"
                             "end\n";
  const std::string plane  = "set Shape = plane\nsubsection Plane\n"
                             " set Normal = 0, 1\nend\n";
  constexpr auto    mortar = ContactConstraint::mortar;
  for (const unsigned int degree : {1u, 2u})
    BOOST_TEST_CONTEXT("degree " << degree)
    {
      const BodyOnTool flat(
        rectangle("0, 0 ; 2, 1", "7, 1", degree), "bottom", circle, {}, mortar);
      BOOST_TEST(smallest_gap(flat.contact, flat.solid.n_dofs()) > 0.);

      const BodyOnTool round(half_disc(degree), "rim", plane, {}, mortar);
      double           l = 1.;
      for (const auto &node : round.contact.pairs()[0].contactor.nodes)
        if (node.point[0] > 1e-6)
          l = std::min(l, node.point[0]);
      const double mean = degree == 1 ? l * l / 8. : l * l / 24.;
      const double gap  = smallest_gap(round.contact, round.solid.n_dofs());
      BOOST_TEST(std::abs(gap / mean - 1.) < 0.02);

      for (const bool disc_is_contactor : {false, true})
        {
          std::string     disc = half_disc(degree);
          std::string     slab = rectangle("-1, -1 ; 1, 0", "9, 1", degree);
          const TwoBodies both(disc_is_contactor ? disc : slab,
                               disc_is_contactor ? "rim" : "top",
                               disc_is_contactor ? slab : disc,
                               disc_is_contactor ? "top" : "rim",
                               {SurfaceInterpolation::Kind::trace},
                               mortar);
          BOOST_TEST(smallest_gap(both.contact, both.solid.n_dofs()) > 0.);
        }
    }
}



// A node that goes a little inside while the mean around it stays outside has
// not passed; one whose body is beyond has.
BOOST_AUTO_TEST_CASE(passage)
{
  for (const unsigned int degree : {1u, 2u})
    BOOST_TEST_CONTEXT("degree " << degree)
    {
      const TwoBodies bodies = blocks(cases[0], degree, 0.);
      const auto     &nodes  = bodies.contact.pairs()[0].contactor.nodes;
      Vector<double>  before(bodies.solid.n_dofs());
      for (const auto &node : bodies.solid.parts()[0].body->nodes())
        before[node.dofs[1]] = 0.01;
      Vector<double> inside(before), beyond(before);
      inside[nodes[1].dofs[1]] = -1e-4;
      for (const auto &node : nodes)
        beyond[node.dofs[1]] = -3.;
      std::vector<double> gaps;
      for (const auto &point : bodies.contact.evaluate({before, 0.}))
        gaps.push_back(point.gap);
      for (const auto &point : bodies.contact.evaluate({inside, 0.}))
        BOOST_TEST(point.gap > 0.);
      const std::vector<bool> open(nodes.size(), false);
      BOOST_TEST(
        bodies.contact
          .tunnelling_candidates({inside, 1.}, {before, 0.}, gaps, open)
          .empty());
      BOOST_TEST(
        bodies.contact
          .tunnelling_candidates({beyond, 1.}, {before, 0.}, gaps, open)
          .size() == nodes.size());
    }
}



// Gaps of all nodes can be prescribed, and the motion of the contactor that
// does it is not larger on finer meshes: multipliers and displacements are a
// stable pair.
BOOST_AUTO_TEST_CASE(independent_rows)
{
  const std::vector<double> largest = {3., 2.7};
  for (const unsigned int degree : {1u, 2u})
    for (const unsigned int cells : {2u, 8u, 32u})
      BOOST_TEST_CONTEXT("degree " << degree << ", " << cells << " cells")
      {
        const TwoBodies bodies =
          blocks({"", 0., 3., cells, "", ""}, degree, 0.);
        const Vector<double> u(bodies.solid.n_dofs());
        const auto           points = bodies.contact.evaluate({u, 0.});
        const unsigned int   n      = points.size();
        std::map<unsigned int, unsigned int> column;
        for (const auto &node : bodies.contact.pairs()[0].contactor.nodes)
          column.emplace(node.dofs[1], column.size());
        FullMatrix<double> rows(n, n);
        for (unsigned int k = 0; k < n; ++k)
          for (const auto &[unknown, entry] : points[k].gap_gradient)
            if (column.count(unknown) > 0)
              rows(k, column.at(unknown)) += entry;
        rows.gauss_jordan();
        BOOST_TEST(rows.linfty_norm() < largest[degree - 1]);
      }
}

BOOST_AUTO_TEST_SUITE_END()
