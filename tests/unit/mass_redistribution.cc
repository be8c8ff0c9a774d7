#include <deal.II/lac/lapack_full_matrix.h>

#include <boost/test/unit_test.hpp>

#include "test_body.h"

BOOST_AUTO_TEST_SUITE(mass_redistribution)

using namespace Signorini;
using namespace dealii;

namespace
{
  // A block with local refinement, so that there are hanging nodes; its bottom
  // and right sides are candidates.
  SolidModel<2>
  block(const unsigned int degree, const ContactMass kind)
  {
    auto        model = test_model<2>("set Mesh = rectangle\n"
                                      "subsection Rectangle\n"
                                      " set Corners = 0, 0 ; 2, 1\n"
                                      " set Cells = 6, 4\nend\n"
                                      "set Refinements near = 0, 1 : 0.4 : 1\n"
                                      "set Element degree = " +
                                 std::to_string(degree) +
                                 "\nsubsection Material\n"
                                        " set Young's modulus = 1000\n"
                                        " set Density = 3\nend\n",
                               Formulation::plane_stress);
    const auto &body  = *model.parts()[0].body;
    auto        nodes = body.boundary_nodes("bottom");
    const auto  right = body.boundary_nodes("right");
    nodes.insert(nodes.end(), right.begin(), right.end());
    model.assemble({true, false, kind, {nodes}});
    return model;
  }

  // v.M v for the velocity field f of place and component.
  template <typename Field>
  double
  energy(const SolidModel<2> &model, const Field &field)
  {
    return model.mass().matrix_norm_square(interpolate(model, field));
  }

  const auto translation = [](const Point<2> &, const unsigned int c) {
    return c == 0 ? 1. : 0.3;
  };
  const auto rotation = [](const Point<2> &p, const unsigned int c) {
    return c == 0 ? -p[1] : p[0];
  };
  const auto stretch = [](const Point<2> &p, const unsigned int c) {
    return c == 0 ? p[0] + 2. * p[1] : 0.5 * p[1];
  };
} // namespace



// Affine weights keep the kinetic energy of every affine velocity field, and
// with it mass, centre of mass and moments of inertia.
BOOST_AUTO_TEST_CASE(affine_weights_keep_affine_fields)
{
  for (const unsigned int degree : {1u, 2u})
    {
      const auto original = block(degree, ContactMass::consistent);
      const auto moved    = block(degree, ContactMass::affine);
      BOOST_TEST(!moved.mass_redistribution().empty());
      BOOST_TEST(
        std::abs(energy(original, translation) / (3. * 2. * (1. + 0.09)) - 1.) <
        1e-12);
      BOOST_TEST(
        std::abs(energy(original, rotation) / (3. * (8. / 3. + 2. / 3.)) - 1.) <
        1e-12);
      for (const auto &[found, truth] :
           {std::make_pair(energy(moved, translation),
                           energy(original, translation)),
            std::make_pair(energy(moved, rotation), energy(original, rotation)),
            std::make_pair(energy(moved, stretch), energy(original, stretch))})
        BOOST_TEST(std::abs(found / truth - 1.) < 1e-11);
    }
}



// Nearest-node weights keep total mass; the rest is off by the small distance
// over which mass was moved.
BOOST_AUTO_TEST_CASE(nearest_weights_keep_mass)
{
  const auto original = block(1, ContactMass::consistent);
  const auto moved    = block(1, ContactMass::redistributed);
  BOOST_TEST(
    std::abs(energy(moved, translation) / energy(original, translation) - 1.) <
    1e-12);
  const double change = energy(moved, rotation) / energy(original, rotation);
  BOOST_TEST(change < 1.);
  BOOST_TEST(change > 0.7);
}



// No entry at a contact node, positive definite on the others.
BOOST_AUTO_TEST_CASE(definite_off_the_contact_nodes)
{
  for (const auto kind : {ContactMass::redistributed, ContactMass::affine})
    {
      const auto                model = block(1, kind);
      std::vector<unsigned int> massive;
      for (unsigned int i = 0; i < model.n_dofs(); ++i)
        if (model.mass_redistribution().is_massless(i))
          for (auto entry = model.mass().begin(i); entry != model.mass().end(i);
               ++entry)
            BOOST_TEST(entry->value() == 0.);
        else if (!model.is_fixed()[i])
          massive.push_back(i);
      LAPACKFullMatrix<double> dense(massive.size());
      for (unsigned int i = 0; i < massive.size(); ++i)
        for (unsigned int j = 0; j < massive.size(); ++j)
          {
            dense(i, j) = model.mass().el(massive[i], massive[j]);
            BOOST_TEST(
              std::abs(dense(i, j) - model.mass().el(massive[j], massive[i])) <
              1e-14);
          }
      FullMatrix<double> vectors;
      Vector<double>     values;
      dense.compute_eigenvalues_symmetric(-1e3, 1e3, 1e-14, values, vectors);
      BOOST_TEST(values.size() == massive.size());
      BOOST_TEST(values[0] > 0.);
    }
}

BOOST_AUTO_TEST_SUITE_END()
