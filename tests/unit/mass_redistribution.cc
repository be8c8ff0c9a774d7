#include <deal.II/lac/lapack_full_matrix.h>

#include <boost/test/unit_test.hpp>

#include "test_body.h"

BOOST_AUTO_TEST_SUITE(mass_redistribution)

using namespace Signorini;
using namespace dealii;

namespace
{
  // A block with local refinement, so that there are hanging nodes.
  SolidModel<2>
  block(const unsigned int degree,
        const Formulation  formulation = Formulation::plane_stress,
        const std::string &entries     = "")
  {
    auto model = test_model<2>("set Mesh = rectangle\n"
                               "subsection Rectangle\n"
                               " set Corners = 0.5, 0 ; 2.5, 1\n"
                               " set Cells = 12, 8\nend\n"
                               "set Refinements near = 0.5, 1 : 0.3 : 1\n"
                               "set Element degree = " +
                                 std::to_string(degree) +
                                 "\nsubsection Material\n"
                                 " set Young's modulus = 1000\n"
                                 " set Density = 3\nend\n" +
                                 entries,
                               formulation);
    model.assemble({true, false, ContactMass::redistributed, {{}}});
    return model;
  }

  SolidModel<3>
  cube(const unsigned int degree)
  {
    auto model = test_model<3>("set Mesh = box\n"
                               "subsection Box\n"
                               " set Corners = 0, 0, 0 ; 1, 1, 1\n"
                               " set Cells = 5, 5, 5\nend\n"
                               "set Element degree = " +
                                 std::to_string(degree) +
                                 "\nsubsection Material\n"
                                 " set Young's modulus = 1000\n"
                                 " set Density = 3\nend\n",
                               Formulation::three_dimensional);
    model.assemble({true, false, ContactMass::redistributed, {{}}});
    return model;
  }

  // First unknowns of the nodes of a boundary that satisfy a condition.
  template <int dim, typename Condition>
  std::vector<unsigned int>
  nodes_on(const SolidModel<dim> &model,
           const std::string     &boundary,
           const Condition       &condition)
  {
    std::vector<unsigned int> unknowns;
    for (const auto &node : model.parts()[0].body->boundary_nodes(boundary))
      if (condition(node.point))
        unknowns.push_back(node.dofs[0]);
    std::sort(unknowns.begin(), unknowns.end());
    return unknowns;
  }

  template <int dim>
  std::vector<unsigned int>
  nodes_on(const SolidModel<dim> &model, const std::string &boundary)
  {
    return nodes_on(model, boundary, [](const Point<dim> &) { return true; });
  }

  // Fields affine in the place: 1 or a coordinate in one component.
  template <int dim>
  std::vector<Vector<double>>
  affine_fields(const SolidModel<dim> &model)
  {
    std::vector<Vector<double>> fields;
    for (unsigned int c = 0; c < dim; ++c)
      for (unsigned int d = 0; d <= dim; ++d)
        fields.push_back(
          interpolate(model, [&](const Point<dim> &p, const unsigned int i) {
            return i != c ? 0. : d < dim ? p[d] : 1.;
          }));
    return fields;
  }

  // Largest change of a^T M b over affine fields, relative to the largest.
  template <int dim>
  double
  change_of_moments(const SolidModel<dim>           &model,
                    const std::vector<unsigned int> &massless)
  {
    const auto mass   = model.redistribute_mass(massless);
    const auto fields = affine_fields(model);
    double     change = 0., largest = 0.;
    for (const auto &a : fields)
      for (const auto &b : fields)
        {
          const double before = model.mass().matrix_scalar_product(a, b);
          const double after  = mass->matrix.matrix_scalar_product(a, b);
          change              = std::max(change, std::abs(after - before));
          largest             = std::max(largest, std::abs(before));
        }
    BOOST_TEST(mass->changed_bodies.empty() == (change < 1e-9 * largest));
    return change / largest;
  }

  // Smallest eigenvalue of the mass matrix on the unknowns with mass, relative
  // to the largest; checks that the others have no entries.
  template <int dim>
  double
  smallest_eigenvalue(const SolidModel<dim>           &model,
                      const std::vector<unsigned int> &massless_nodes)
  {
    const auto                mass = model.redistribute_mass(massless_nodes);
    const auto               &redistribution = mass->redistribution;
    std::vector<unsigned int> massive;
    for (unsigned int i = 0; i < model.n_dofs(); ++i)
      if (redistribution.is_massless(i))
        for (auto entry = mass->matrix.begin(i); entry != mass->matrix.end(i);
             ++entry)
          BOOST_TEST(entry->value() == 0.);
      else if (!model.dof_map().is_constrained(i))
        massive.push_back(i);
    LAPACKFullMatrix<double> dense(massive.size());
    for (unsigned int i = 0; i < massive.size(); ++i)
      for (unsigned int j = 0; j < massive.size(); ++j)
        dense(i, j) = mass->matrix.el(massive[i], massive[j]);
    FullMatrix<double> vectors;
    Vector<double>     values;
    dense.compute_eigenvalues_symmetric(-1e3, 1e3, 1e-14, values, vectors);
    BOOST_TEST(values.size() == massive.size());
    return values[0] / values[values.size() - 1];
  }
} // namespace



// Whatever nodes lose their mass: mass, centre and moments of inertia of the
// body are those of the consistent matrix.
BOOST_AUTO_TEST_CASE(moments_are_kept)
{
  for (const auto formulation :
       {Formulation::plane_stress, Formulation::axisymmetric})
    for (const unsigned int degree : {1u, 2u})
      {
        const auto model = block(degree, formulation);
        BOOST_TEST(change_of_moments(model, nodes_on(model, "bottom")) < 1e-11);
        BOOST_TEST(change_of_moments(model, nodes_on(model, "left")) < 1e-11);
        BOOST_TEST(
          change_of_moments(model, nodes_on(model, "right", [](const auto &p) {
                              return p[1] > 0.7;
                            })) < 1e-11);
      }
  for (const unsigned int degree : {1u, 2u})
    {
      const auto model = cube(degree);
      BOOST_TEST(change_of_moments(model, nodes_on(model, "bottom")) < 1e-11);
    }
}



// Nodes that a support holds keep their mass, component by component.
BOOST_AUTO_TEST_CASE(moments_are_kept_at_supports)
{
  const auto model =
    block(1,
          Formulation::plane_stress,
          "subsection Supports\n set Fixed = bottom: x\nend\n");
  const auto nodes = nodes_on(model, "bottom");
  BOOST_TEST(change_of_moments(model, nodes) < 1e-11);
  const auto mass = model.redistribute_mass(nodes);
  for (const unsigned int node : nodes)
    {
      BOOST_TEST(mass->matrix.diag_element(node) > 0.);
      BOOST_TEST(mass->matrix.diag_element(node + 1) == 0.);
    }
}



// Two layers of cells, one of which has lost its mass, bear no moment of
// inertia of positive masses: the mass is kept, and the body is named.
BOOST_AUTO_TEST_CASE(thin_bodies_keep_their_mass)
{
  auto model = test_model<2>("set Mesh = rectangle\n"
                             "subsection Rectangle\n"
                             " set Corners = 0, 0 ; 2, 0.1\n"
                             " set Cells = 20, 2\nend\n"
                             "subsection Material\n"
                             " set Young's modulus = 1000\n"
                             " set Density = 3\nend\n",
                             Formulation::plane_stress);
  model.assemble({true, false, ContactMass::redistributed, {{}}});
  const auto nodes = nodes_on(model, "bottom");
  const auto mass  = model.redistribute_mass(nodes);
  BOOST_TEST(mass->changed_bodies.size() == 1u);
  const auto one =
    interpolate(model, [](const Point<2> &, const unsigned int c) {
      return double(c == 1);
    });
  BOOST_TEST(std::abs(mass->matrix.matrix_norm_square(one) / 0.6 - 1.) < 1e-12);
  BOOST_TEST(smallest_eigenvalue(model, nodes) > 0.);
}



BOOST_AUTO_TEST_CASE(definite_off_the_contact_nodes)
{
  for (const unsigned int degree : {1u, 2u})
    {
      const auto model = block(degree);
      auto       nodes = nodes_on(model, "bottom");
      BOOST_TEST(smallest_eigenvalue(model, nodes) > 1e-4);
      const auto right = nodes_on(model, "right");
      nodes.insert(nodes.end(), right.begin(), right.end());
      std::sort(nodes.begin(), nodes.end());
      BOOST_TEST(smallest_eigenvalue(model, nodes) > 1e-4);
    }
}



// A body that nothing touches has the mass matrix that it would have alone.
BOOST_AUTO_TEST_CASE(untouched_bodies_keep_their_matrix)
{
  const auto model = block(1);
  const auto mass  = model.redistribute_mass({});
  BOOST_TEST(mass->redistribution.empty());
  for (unsigned int i = 0; i < model.n_dofs(); ++i)
    for (auto entry = mass->matrix.begin(i); entry != mass->matrix.end(i);
         ++entry)
      BOOST_TEST(entry->value() == model.mass().el(i, entry->column()));
}



// The velocity of a massless node is that of an affine motion of the others.
BOOST_AUTO_TEST_CASE(velocities_are_extrapolated)
{
  const auto model = block(2);
  const auto nodes = nodes_on(model, "bottom");
  const auto mass  = model.redistribute_mass(nodes);
  for (const auto &field : affine_fields(model))
    {
      Vector<double> velocity(field);
      mass->redistribution.clear_massless(velocity);
      mass->redistribution.extrapolate(velocity);
      velocity -= field;
      BOOST_TEST(velocity.linfty_norm() < 1e-12);
    }
}

BOOST_AUTO_TEST_SUITE_END()
