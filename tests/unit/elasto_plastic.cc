#include <boost/test/unit_test.hpp>

#include "material_point.h"
#include "test_laws.h"

BOOST_AUTO_TEST_SUITE(elasto_plastic)

using namespace Signorini;
using namespace dealii;

namespace
{
  const double E = 200e9, nu = 0.3, sigma_0 = 200e6;
  const double G = E / (2. * (1. + nu));

  using TestLaws::linear, TestLaws::prager;

  const std::string steel = linear + "set Hardening modulus = 0\n";
  const std::string less  = "set Hardening modulus = 100e6\n";
  const std::string voce  = TestLaws::voce + less;
  const std::string table =
    steel + "set Hardening = table\n"
            "set Hardening table = 0: 200e6 | 0.01: 260e6 | 0.1: 350e6\n";
  const std::string armstrong_frederick = TestLaws::armstrong_frederick + less;
  const std::string johnson_cook = voce + "set Rate dependence = Johnson-Cook\n"
                                          "set Rate coefficient = 0.02\n"
                                          "set Reference rate = 1e-3\n";

  const auto both = {Kinematics::small_strain, Kinematics::finite_strain};

  // The stretch that belongs to a uniaxial strain.
  double
  stretch_of(const double strain, const Kinematics kinematics)
  {
    return 1. + (kinematics == Kinematics::small_strain ? strain :
                                                          std::expm1(strain));
  }

  double
  relative(const double found, const double truth)
  {
    return std::abs(found / truth - 1.);
  }

  // Uniaxial stress with a given plastic strain at its end, in steps that grow:
  // the exact solution is stress/E + plastic strain = strain.
  void
  check_uniaxial(const std::string                         &entries,
                 const std::function<double(const double)> &yield_stress)
  {
    for (const Kinematics kinematics : both)
      {
        PointOfMaterial point(entries, kinematics);
        for (const double plastic : {1e-6, 1e-3, 0.009, 0.03, 0.2, 0.5})
          {
            const double truth  = yield_stress(plastic);
            const double strain = truth / E + plastic;
            const auto response = point.stretch(stretch_of(strain, kinematics));
            BOOST_TEST(relative(response.stress[0][0], truth) < 1e-12);
            BOOST_TEST(relative(point.equivalent_plastic_strain(), plastic) <
                       1e-9);
          }
      }
  }
} // namespace



// Hencky's elasticity, logarithmic J2: stress and force, given to ten digits by
// an independent evaluation; and its closed form.
BOOST_AUTO_TEST_CASE(uniaxial_in_large_strains)
{
  const double stretches[] = {1.01, 1.1, 1.5, 2.};
  const double stresses[]  = {208.9058, 293.8410, 602.4529, 888.7037};
  const double forces[]    = {206.8374, 267.1282, 401.6352, 444.3518};
  const double H           = 1000e6;
  for (const bool in_one_step : {true, false})
    {
      PointOfMaterial point(linear, Kinematics::finite_strain);
      for (unsigned int i = 0; i < 4; ++i)
        {
          if (in_one_step)
            point = PointOfMaterial(linear, Kinematics::finite_strain);
          const auto   response = point.stretch(stretches[i]);
          const double truth =
            (std::log(stretches[i]) + sigma_0 / H) / (1. / E + 1. / H);
          const double stress = response.stress[0][0];
          BOOST_TEST(relative(stress, truth) < 1e-12);
          BOOST_TEST(relative(stress, 1e6 * stresses[i]) < 1e-6);
          BOOST_TEST(relative(stress / stretches[i], 1e6 * forces[i]) < 1e-6);
          // int tau d ln(lambda), exact in any number of steps
          BOOST_TEST(relative(response.energy_density,
                              truth * truth / (2. * E)) < 1e-11);
          BOOST_TEST(relative(response.plastic_work_density,
                              (truth * truth - sigma_0 * sigma_0) / (2. * H)) <
                     1e-11);
        }
    }
}



BOOST_AUTO_TEST_CASE(uniaxial_hardening)
{
  check_uniaxial(linear, [](const double a) { return sigma_0 + 1000e6 * a; });
  check_uniaxial(steel, [](const double) { return sigma_0; });
  check_uniaxial(voce, [](const double a) {
    return sigma_0 + 100e6 * a + 150e6 * (1. - std::exp(-12. * a));
  });
  check_uniaxial(table, [](const double a) {
    return a < 0.01 ? sigma_0 + 6e9 * a :
           a < 0.1  ? 260e6 + 1e9 * (a - 0.01) :
                      350e6;
  });
  check_uniaxial(prager,
                 [](const double a) { return sigma_0 + (1000e6 + 5e9) * a; });
}



// The plastic work of a straight path is the integral of the yield stress, in
// one step and in many.
BOOST_AUTO_TEST_CASE(plastic_work)
{
  const double a = 0.3;
  const double truth =
    200e6 * a + 50e6 * a * a + 150e6 * (a - (1. - std::exp(-12. * a)) / 12.);
  const double stress = 200e6 + 100e6 * a + 150e6 * (1. - std::exp(-12. * a));
  const double table_truth = 2.3e6 + 27.45e6 + 350e6 * 0.2;
  for (const Kinematics kinematics : both)
    for (const unsigned int n_steps : {1u, 7u})
      {
        PointOfMaterial  point(voce, kinematics), listed(table, kinematics);
        MaterialResponse last, last_listed;
        for (unsigned int n = 1; n <= n_steps; ++n)
          {
            const double share = static_cast<double>(n) / n_steps;
            last =
              point.stretch(stretch_of(share * (a + stress / E), kinematics));
            last_listed =
              listed.stretch(stretch_of(share * (0.3 + 350e6 / E), kinematics));
          }
        BOOST_TEST(relative(last.plastic_work_density, truth) < 1e-11);
        BOOST_TEST(relative(last_listed.plastic_work_density, table_truth) <
                   1e-11);
      }
}



// Under simple shear in small strains the shear stress is sigma_y/sqrt(3), and
// the equivalent plastic strain gamma_p/sqrt(3).
BOOST_AUTO_TEST_CASE(simple_shear)
{
  PointOfMaterial point(linear, Kinematics::small_strain);
  for (const double gamma : {0.01, -0.02, 0.05})
    {
      const double a_n = point.equivalent_plastic_strain();
      Tensor<2, 3> gradient;
      gradient[0][1]        = gamma;
      const auto   response = point.advance(gradient);
      const double a        = point.equivalent_plastic_strain();
      BOOST_TEST(a > a_n);
      BOOST_TEST(relative(std::sqrt(3.) * std::abs(response.stress[0][1]),
                          sigma_0 + 1000e6 * a) < 1e-13);
      BOOST_TEST(std::abs(response.stress[0][0]) < 1e-6);
    }
}



// Armstrong and Frederick: after much strain the stress is that of the yield
// curve, plus H_k/gamma = 100 MPa. Reversed, it begins to yield 200 MPa lower
// than without.
BOOST_AUTO_TEST_CASE(armstrong_frederick_saturates)
{
  for (const Kinematics kinematics : both)
    {
      PointOfMaterial point(armstrong_frederick +
                              "set Hardening modulus = 0\n"
                              "set Saturation exponent = 100\n",
                            kinematics);
      double          stress = 0.;
      for (unsigned int n = 1; n <= 60; ++n)
        stress = point.stretch(stretch_of(0.01 * n, kinematics)).stress[0][0];
      BOOST_TEST(relative(stress, 450e6) < 1e-12);

      const double yield  = 350e6;
      const double before = point.equivalent_plastic_strain();
      const double drop   = (2. * yield - 1e3) / E;
      point.stretch(stretch_of(0.6 - drop, kinematics));
      BOOST_TEST(point.equivalent_plastic_strain() == before);
      point.stretch(stretch_of(0.6 - drop - 1e-6, kinematics));
      BOOST_TEST(point.equivalent_plastic_strain() > before);
    }
}



// Prager's hardening moves the surface without growing it.
BOOST_AUTO_TEST_CASE(bauschinger_effect)
{
  PointOfMaterial point(prager + "set Hardening modulus = 0\n",
                        Kinematics::small_strain);
  const double    H_k    = 5e9;
  const double    top    = sigma_0 + H_k * 0.01;
  double          stress = point.stretch(1. + 0.01 + top / E).stress[0][0];
  BOOST_TEST(relative(stress, top) < 1e-12);
  // back to the plastic strain -0.01
  const double bottom = -sigma_0 - H_k * 0.01;
  stress              = point.stretch(1. - 0.01 + bottom / E).stress[0][0];
  BOOST_TEST(relative(stress, bottom) < 1e-12);
  BOOST_TEST(relative(point.equivalent_plastic_strain(), 0.03) < 1e-12);
}



// Without hardening a steady rate of strain ends in a steady rate of flow:
// stress = sigma_0 (1 + C ln(rate/rate_0)). Slower than rate_0 it is sigma_0.
BOOST_AUTO_TEST_CASE(johnson_cook_rates)
{
  for (const Kinematics kinematics : both)
    for (const double rate : {1e-5, 1e-3, 0.1, 1e4})
      {
        PointOfMaterial point(johnson_cook + "set Hardening = linear\n"
                                             "set Hardening modulus = 0\n",
                              kinematics);
        double          stress = 0.;
        for (unsigned int n = 1; n <= 50; ++n)
          stress = point.stretch(stretch_of(1e-3 * n, kinematics), 1e-3 / rate)
                     .stress[0][0];
        const double truth =
          sigma_0 * (1. + 0.02 * std::max(std::log(rate / 1e-3), 0.));
        BOOST_TEST(relative(stress, truth) < 1e-10);
      }
}



// One step of all that hardens against the equation of the step, bisected.
BOOST_AUTO_TEST_CASE(equation_of_a_step)
{
  RandomDeformations random(5);
  PointOfMaterial    point(armstrong_frederick +
                          "set Rate dependence = Johnson-Cook\n"
                             "set Rate coefficient = 0.05\n"
                             "set Reference rate = 1e-2\n",
                        Kinematics::small_strain);
  const double       step_size = 0.1;
  point.advance(random.gradient(0.02, false), step_size);
  for (unsigned int step = 0; step < 50; ++step)
    {
      const double                a_n = point.equivalent_plastic_strain();
      const SymmetricTensor<2, 3> back_n({point.history_n[2],
                                          point.history_n[3],
                                          point.history_n[4],
                                          point.history_n[5],
                                          point.history_n[6],
                                          point.history_n[7]});
      SymmetricTensor<2, 3>       plastic;
      for (unsigned int i = 0; i < 6; ++i)
        plastic.access_raw_entry(i) = point.history_n[8 + i];
      const Tensor<2, 3>          gradient = random.gradient(0.02, step % 2);
      const SymmetricTensor<2, 3> trial =
        2. * G * deviator(symmetrize(gradient) - plastic);
      double lower = 0., upper = 1.;
      for (unsigned int i = 0; i < 200; ++i)
        {
          const double x = 0.5 * (lower + upper), w = 1. + 200. * x;
          const double a = a_n + x;
          const double yield =
            200e6 + 100e6 * a + 150e6 * (1. - std::exp(-12. * a));
          const double factor =
            1. + 0.05 * std::max(std::log(x / step_size / 1e-2), 0.);
          const double f = std::sqrt(1.5) * (trial - back_n / w).norm() -
                           (3. * G + 20e9 / w) * x - yield * factor;
          (f > 0. ? lower : upper) = x;
        }
      point.advance(gradient, step_size);
      const double increment = point.equivalent_plastic_strain() - a_n;
      BOOST_TEST(std::abs(increment - lower) < 1e-13);
    }
}



// Random walks: the tangent in small strains, and that the dissipation
// (plastic work less what the back stress stores) never falls.
BOOST_AUTO_TEST_CASE(tangent_in_small_strains)
{
  RandomDeformations random(6);
  double             worst = 0.;
  for (const std::string &entries :
       {linear, voce, table, prager, armstrong_frederick, johnson_cook})
    {
      PointOfMaterial point(entries, Kinematics::small_strain);
      for (unsigned int step = 0; step < 20; ++step)
        {
          const Tensor<2, 3> gradient = random.gradient(0.01, step % 2);
          const auto         found    = point.respond(gradient, 1e-2);
          const auto truth = numerical_tangent(point, gradient, 1e-6, 1e-2);
          worst = std::max(worst, relative_difference(found.tangent, truth));
          point.advance(gradient, 1e-2);
        }
    }
  BOOST_TEST_MESSAGE("tangent in small strains: " << worst);
  BOOST_TEST(worst < 1e-8);
}



BOOST_AUTO_TEST_CASE(dissipation)
{
  RandomDeformations random(7);
  for (const Kinematics kinematics : both)
    for (const std::string &entries :
         {linear, voce, prager, armstrong_frederick, johnson_cook})
      {
        const double    H_k = entries == prager              ? 5e9 :
                              entries == armstrong_frederick ? 20e9 :
                                                               0.;
        PointOfMaterial point(entries, kinematics);
        double          last = 0.;
        for (unsigned int step = 0; step < 100; ++step)
          {
            const auto response =
              point.advance(random.gradient(0.02, step % 2), 1e-2);
            double stored = 0.;
            if (H_k > 0.)
              for (unsigned int i = 0; i < 6; ++i)
                stored += (i < 3 ? 0.75 : 1.5) / H_k * point.history_n[2 + i] *
                          point.history_n[2 + i];
            const double dissipated = response.plastic_work_density - stored;
            BOOST_TEST(dissipated >= last);
            last = dissipated;
          }
      }
}



// Energy and plastic work together are the work of the stress: over a curved
// path the difference falls with the square of the step.
BOOST_AUTO_TEST_CASE(work_of_the_stress)
{
  for (const Kinematics kinematics : both)
    for (const std::string &entries : {voce, prager, armstrong_frederick})
      {
        double errors[2];
        for (const unsigned int level : {0u, 1u})
          {
            const unsigned int n_steps = level ? 1600 : 800;
            PointOfMaterial    point(entries, kinematics);
            Tensor<2, 3>       F    = unit_tensor(), stress;
            double             work = 0.;
            MaterialResponse   last;
            for (unsigned int n = 1; n <= n_steps; ++n)
              {
                const double t = static_cast<double>(n) / n_steps;
                Tensor<2, 3> gradient;
                gradient[0][0]              = 0.03 * t;
                gradient[1][1]              = -0.03 * t * t;
                gradient[0][1]              = 0.04 * std::sin(3. * t);
                gradient[2][1]              = 0.02 * t * t;
                last                        = point.advance(gradient);
                const Tensor<2, 3> F_n      = F;
                const Tensor<2, 3> stress_n = stress;
                F                           = unit_tensor() + gradient;
                stress                      = last.stress;
                // trapezoidal rule of P : dF
                if (kinematics == Kinematics::finite_strain)
                  stress = stress * transpose(invert(F));
                work += 0.5 * scalar_product(stress + stress_n, F - F_n);
              }
            errors[level] =
              std::abs(work - last.energy_density - last.plastic_work_density) /
              work;
          }
        BOOST_TEST_MESSAGE("work of the stress: " << errors[0] << ' '
                                                  << errors[1]);
        BOOST_TEST(errors[1] < 1e-5);
        BOOST_TEST(errors[0] / errors[1] > 3.5);
      }
}

BOOST_AUTO_TEST_SUITE_END()
