#include <boost/test/unit_test.hpp>

#include "material_point.h"
#include "potential.h"

BOOST_AUTO_TEST_SUITE(elastic_materials)

using namespace Signorini;
using namespace dealii;

namespace
{
  const double E = 2e9, nu = 0.4;
  const double mu     = E / (2. * (1. + nu));
  const double lambda = 2. * mu * nu / (1. - 2. * nu);

  std::string
  law(const std::string &name)
  {
    return "set Law = " + name +
           "\nset Young's modulus = 2e9\nset Poisson's ratio = 0.4\n";
  }
} // namespace



// Hooke's law; in small strains neo-Hooke is the same.
BOOST_AUTO_TEST_CASE(hooke)
{
  RandomDeformations random(41);
  for (const std::string name : {"elastic", "neo-Hooke"})
    {
      const PointOfMaterial point(law(name), Kinematics::small_strain);
      BOOST_TEST(point.material->is_linear());
      BOOST_TEST(point.material->n_history_values() == 0u);
      for (const double size : {1e-12, 1e-3})
        {
          const Tensor<2, 3>          gradient = random.gradient(size, false);
          const SymmetricTensor<2, 3> strain   = symmetrize(gradient);
          const SymmetricTensor<2, 3> stress =
            lambda * trace(strain) * unit_symmetric_tensor<3>() +
            2. * mu * strain;
          const auto found = point.respond(gradient);
          BOOST_TEST(relative_difference(found.stress, stress) < 1e-15);
          BOOST_TEST(relative_difference(found.tangent * strain, stress) <
                     1e-15);
          BOOST_TEST(std::abs(found.energy_density / (0.5 * strain * stress) -
                              1.) < 1e-14);
          BOOST_TEST(found.plastic_work_density == 0.);
        }
    }
}



// Neo-Hooke: energy, stress and tangent from its potential by Sacado.
BOOST_AUTO_TEST_CASE(neo_hooke_against_sacado)
{
  RandomDeformations    random(42);
  const PointOfMaterial point(law("neo-Hooke"), Kinematics::finite_strain);
  BOOST_TEST(!point.material->is_linear());
  double worst = 0.;
  for (unsigned int trial = 0; trial < 50; ++trial)
    {
      const Tensor<2, 3> gradient = random.gradient(0.5, trial % 2);
      if (determinant(unit_tensor() + gradient) < 0.1)
        continue;
      const auto found = point.respond(gradient);
      const auto truth = differentiate(NeoHookePotential{E, nu}, gradient);
      worst =
        std::max({worst,
                  relative_difference(found.stress, truth.stress),
                  relative_difference(found.tangent, truth.tangent),
                  std::abs(found.energy_density / truth.energy_density - 1.)});
    }
  BOOST_TEST_MESSAGE("neo-Hooke against Sacado: " << worst);
  BOOST_TEST(worst < 1e-12);
}



// For strains h it differs from Hooke's law by h, with all digits, and the
// energy is continuous where its series ends.
BOOST_AUTO_TEST_CASE(neo_hooke_in_small_strains)
{
  RandomDeformations    random(43);
  const PointOfMaterial finite(law("neo-Hooke"), Kinematics::finite_strain);
  const PointOfMaterial small(law("neo-Hooke"), Kinematics::small_strain);
  for (const double h : {1e-14, 1e-12, 1e-8, 1e-4})
    {
      const Tensor<2, 3> gradient = random.gradient(h, false);
      const auto         a        = small.respond(gradient);
      const auto         b        = finite.respond(gradient);
      const double       bound    = 20. * h + 1e-14;
      BOOST_TEST(relative_difference(b.stress, a.stress) < bound);
      BOOST_TEST(relative_difference(b.tangent, a.tangent) < bound);
      BOOST_TEST(std::abs(b.energy_density / a.energy_density - 1.) < bound);
    }
  for (const double x : {-0.05, 0.05})
    for (const double side : {-1e-12, 1e-12})
      {
        Tensor<2, 3> gradient;
        gradient[0][0]     = x + side;
        const double log_J = std::log1p(x + side);
        const double truth =
          0.5 * mu * ((2. + x + side) * (x + side) - 2. * log_J) +
          0.5 * lambda * log_J * log_J;
        BOOST_TEST(std::abs(finite.respond(gradient).energy_density / truth -
                            1.) < 1e-13);
      }
}



BOOST_AUTO_TEST_CASE(neo_hooke_turns)
{
  RandomDeformations    random(44);
  const PointOfMaterial point(law("neo-Hooke"), Kinematics::finite_strain);
  for (unsigned int trial = 0; trial < 10; ++trial)
    {
      const Tensor<2, 3> gradient = random.gradient(0.2, false);
      const Tensor<2, 3> Q        = random.rotation(false);
      const auto         plain    = point.respond(gradient);
      const auto         turned =
        point.respond(Q * (unit_tensor() + gradient) - unit_tensor());
      BOOST_TEST(relative_difference(turned.stress, rotated(plain.stress, Q)) <
                 1e-13);
    }
  Tensor<2, 3> inverted;
  inverted[2][2] = -1.;
  BOOST_CHECK_THROW(point.respond(inverted), MaterialFailure);
}

BOOST_AUTO_TEST_SUITE_END()
