#include <signorini/material/principal_frame.h>

#include <boost/test/unit_test.hpp>

#include "material_point.h"
#include "potential.h"
#include "test_laws.h"

BOOST_AUTO_TEST_SUITE(logarithmic_material)

using namespace Signorini;
using namespace dealii;

namespace
{
  using namespace TestLaws;

  const double E = 200e9, nu = 0.3;

  // F_p^-1 of a history, whose last nine values are F_p^-1 - 1.
  Tensor<2, 3>
  inverse_plastic(const std::vector<double> &history)
  {
    Tensor<2, 3> result = unit_tensor();
    for (unsigned int i = 0; i < 9; ++i)
      result[i / 3][i % 3] += history[history.size() - 9 + i];
    return result;
  }

  // Deformations of every kind: random, planar, with two and three equal
  // stretches, nearly equal ones, none.
  std::vector<Tensor<2, 3>>
  gradients(const double size)
  {
    RandomDeformations        random(31);
    std::vector<Tensor<2, 3>> list(1);
    for (unsigned int i = 0; i < 8; ++i)
      list.push_back(random.gradient(size, i % 2));
    for (const bool is_planar : {true, false})
      for (const double gap : {0., 1e-9, 1e-4, 0.3 * size})
        {
          const Tensor<2, 3> R = random.rotation(is_planar);
          const Tensor<2, 3> Q = random.rotation(is_planar);
          Tensor<2, 3>       stretch;
          stretch[0][0] = 1. + size;
          stretch[1][1] = 1. + size - gap;
          stretch[2][2] = 1. - size;
          list.push_back(Q * stretch * transpose(R) - unit_tensor());
          stretch[2][2] = 1. + size - 2. * gap;
          list.push_back(Q * stretch * transpose(R) - unit_tensor());
        }
    return list;
  }

  // A state in the middle of plastic flow.
  PointOfMaterial
  loaded(const std::string &entries, const bool is_planar)
  {
    RandomDeformations random(32);
    PointOfMaterial    point(entries, Kinematics::finite_strain);
    for (unsigned int step = 0; step < 5; ++step)
      point.advance(random.gradient(0.05, is_planar));
    return point;
  }
} // namespace



// Stress and tangent are first and second derivative of the potential of the
// step, by Sacado: elastic, and with one plastic step from the start and from a
// loaded state.
BOOST_AUTO_TEST_CASE(against_sacado)
{
  double worst_stress = 0., worst_tangent = 0.;
  for (const std::string &entries : {hencky, linear})
    for (const bool is_loaded : {false, true})
      {
        if (is_loaded && entries == hencky)
          continue;
        for (const double size : {0.0005, 0.02, 0.4})
          for (const Tensor<2, 3> &gradient : gradients(size))
            {
              PointOfMaterial point =
                is_loaded ? loaded(entries, is_planar(gradient)) :
                            PointOfMaterial(entries, Kinematics::finite_strain);
              HenckyPotential potential = {E, nu};
              if (entries == linear)
                {
                  potential.hardening_modulus = 1000e6;
                  potential.yield_stress =
                    200e6 + 1000e6 * point.equivalent_plastic_strain();
                  potential.inverse_plastic = inverse_plastic(point.history_n);
                }
              const auto found = point.respond(gradient);
              const auto truth = differentiate(potential, gradient);
              if (truth.stress.norm() > 0.)
                worst_stress = std::max(worst_stress,
                                        (found.stress - truth.stress).norm() /
                                          std::max(truth.stress.norm(), 1e8));
              worst_tangent =
                std::max(worst_tangent,
                         relative_difference(found.tangent, truth.tangent));
            }
      }
  BOOST_TEST_MESSAGE("against Sacado: stress " << worst_stress << ", tangent "
                                               << worst_tangent);
  BOOST_TEST(worst_stress < 1e-11);
  BOOST_TEST(worst_tangent < 1e-11);
}



// The tangent of the laws without a potential, or with another hardening, by
// differences. That of Armstrong and Frederick takes the symmetric part of the
// law before the strain, and not after, which is seen in the eighth digit.
BOOST_AUTO_TEST_CASE(tangent_by_differences)
{
  for (const std::string &entries : {hencky, voce, prager, armstrong_frederick})
    {
      double worst = 0.;
      for (const bool is_planar : {true, false})
        {
          const PointOfMaterial point =
            entries == hencky ?
              PointOfMaterial(entries, Kinematics::finite_strain) :
              loaded(entries, is_planar);
          RandomDeformations random(33);
          for (unsigned int i = 0; i < 10; ++i)
            {
              const Tensor<2, 3> gradient = random.gradient(0.1, is_planar);
              worst                       = std::max(
                worst,
                relative_difference(point.respond(gradient).tangent,
                                    numerical_tangent(point, gradient, 2e-5)));
            }
        }
      BOOST_TEST_MESSAGE("tangent by differences: " << worst);
      BOOST_TEST(worst < (entries == armstrong_frederick ? 1e-7 : 1e-10));
    }
}



// A rigid rotation by 90 degrees in one step: the stress turns along, and
// nothing flows. Kirchhoff's stress does as Cauchy's, det F being the same.
BOOST_AUTO_TEST_CASE(rotation_in_one_step)
{
  for (const std::string &entries :
       {hencky, linear, voce, prager, armstrong_frederick})
    for (const bool is_planar : {true, false})
      {
        RandomDeformations random(34);
        PointOfMaterial    point(entries, Kinematics::finite_strain);
        Tensor<2, 3>       gradient;
        MaterialResponse   before;
        for (unsigned int step = 0; step < 4; ++step)
          {
            gradient += random.gradient(0.03, is_planar);
            before = point.advance(gradient);
          }
        const auto history = point.history_n;
        Point<3>   axis;
        axis[2] = 1.;
        if (!is_planar)
          axis = Point<3>(1. / 3., 2. / 3., -2. / 3.);
        const Tensor<2, 3> Q =
          Physics::Transformations::Rotations::rotation_matrix_3d(
            axis, 0.5 * numbers::PI);
        const auto after =
          point.advance(Q * (unit_tensor() + gradient) - unit_tensor());
        BOOST_TEST(
          relative_difference(after.stress, rotated(before.stress, Q)) < 1e-12);
        BOOST_TEST(std::abs(after.energy_density / before.energy_density - 1.) <
                   1e-12);
        // nothing flows
        BOOST_TEST(point.history_n == history);
      }
}



// Superposed rotation from the same history: stress and tangent turn along, the
// history is the same.
BOOST_AUTO_TEST_CASE(superposed_rotation)
{
  RandomDeformations random(35);
  for (const std::string &entries :
       {hencky, linear, voce, prager, armstrong_frederick})
    for (const bool is_planar : {true, false})
      {
        const PointOfMaterial point =
          entries == hencky ?
            PointOfMaterial(entries, Kinematics::finite_strain) :
            loaded(entries, is_planar);
        for (unsigned int i = 0; i < 10; ++i)
          {
            const Tensor<2, 3> gradient = random.gradient(0.1, is_planar);
            const Tensor<2, 3> Q        = random.rotation(is_planar);
            const auto         plain    = point.respond(gradient);
            const auto         history  = point.history;
            const auto         turned =
              point.respond(Q * (unit_tensor() + gradient) - unit_tensor());
            BOOST_TEST(relative_difference(turned.stress,
                                           rotated(plain.stress, Q)) < 1e-12);
            for (unsigned int k = 0; k < history.size(); ++k)
              BOOST_TEST(std::abs(point.history[k] - history[k]) <
                         1e-12 * std::max(1., std::abs(plain.stress.norm())));
            for (unsigned int trial = 0; trial < 3; ++trial)
              {
                const auto d = symmetrize(random.gradient(1., false));
                BOOST_TEST(relative_difference(turned.tangent * rotated(d, Q),
                                               rotated(plain.tangent * d, Q)) <
                           1e-11);
              }
          }
      }
}



// det F_p = 1, also after many steps far into flow.
BOOST_AUTO_TEST_CASE(flow_keeps_the_volume)
{
  for (const std::string &entries : {linear, prager, armstrong_frederick})
    for (const bool is_planar : {true, false})
      {
        RandomDeformations random(36);
        PointOfMaterial    point(entries, Kinematics::finite_strain);
        for (unsigned int step = 0; step < 50; ++step)
          {
            point.advance(random.gradient(0.3, is_planar));
            BOOST_TEST(std::abs(determinant(inverse_plastic(point.history_n)) -
                                1.) < 1e-14);
          }
        BOOST_TEST(point.equivalent_plastic_strain() > 5.);
      }
}



// For strains h the laws of both kinematics differ by h^2, and no digit is lost
// however small they are.
BOOST_AUTO_TEST_CASE(small_strain_limit)
{
  RandomDeformations random(37);
  for (const bool is_planar : {true, false})
    for (unsigned int trial = 0; trial < 5; ++trial)
      {
        const Tensor<2, 3> direction = random.gradient(1., is_planar);
        // h is large against the yield strain, too: scaled with the yield
        // stress
        for (const double h : {1e-12, 1e-8, 1e-4, 1e-3})
          for (const std::string &entries :
               {hencky,
                linear + "set Yield stress = " + std::to_string(0.3 * h * E) +
                  "\n"})
            {
              PointOfMaterial small(entries, Kinematics::small_strain);
              PointOfMaterial finite(entries, Kinematics::finite_strain);
              // two steps: the second from a history
              for (const double factor : {0.7, -0.6})
                {
                  const auto   a     = small.advance(factor * h * direction);
                  const auto   b     = finite.advance(factor * h * direction);
                  const double bound = 20. * h + 1e-14;
                  BOOST_TEST(relative_difference(b.stress, a.stress) < bound);
                  BOOST_TEST(relative_difference(b.tangent, a.tangent) < bound);
                  BOOST_TEST(
                    std::abs(b.energy_density / a.energy_density - 1.) < bound);
                }
            }
      }
}



// The work around closed paths is zero: the trapezoidal rule is exact to
// rounding for periodic functions.
BOOST_AUTO_TEST_CASE(no_work_around_a_cycle)
{
  const PointOfMaterial point(hencky, Kinematics::finite_strain);
  const unsigned int    n    = 200;
  double                work = 0., size = 0.;
  for (unsigned int i = 0; i < n; ++i)
    {
      const double t = 2. * numbers::PI * i / n;
      Tensor<2, 3> gradient, rate;
      gradient[0][0]             = 0.4 * std::sin(t);
      rate[0][0]                 = 0.4 * std::cos(t);
      gradient[0][1]             = 0.5 * std::cos(t);
      rate[0][1]                 = -0.5 * std::sin(t);
      gradient[1][2]             = 0.3 * std::sin(2. * t);
      rate[1][2]                 = 0.6 * std::cos(2. * t);
      const Tensor<2, 3> inverse = invert(unit_tensor() + gradient);
      const double       power =
        point.respond(gradient).stress * symmetrize(rate * inverse);
      work += power / n;
      size += std::abs(power) / n;
    }
  BOOST_TEST(std::abs(work) < 1e-13 * size);
}



BOOST_AUTO_TEST_CASE(inverted_deformations)
{
  for (const std::string &entries : {hencky, linear})
    {
      const PointOfMaterial point(entries, Kinematics::finite_strain);
      Tensor<2, 3>          gradient;
      gradient[0][0]              = -1.25;
      const auto says_determinant = [](const MaterialFailure &failure) {
        return std::string(failure.what()).find("-0.25") != std::string::npos;
      };
      BOOST_CHECK_EXCEPTION(point.respond(gradient),
                            MaterialFailure,
                            says_determinant);
      gradient[0][0] = std::numeric_limits<double>::quiet_NaN();
      BOOST_CHECK_THROW(point.respond(gradient), MaterialFailure);
    }
}

BOOST_AUTO_TEST_SUITE_END()
