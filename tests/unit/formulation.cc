#include <signorini/solid/formulation.h>

#include <boost/test/unit_test.hpp>

#include "material_point.h"
#include "test_laws.h"

BOOST_AUTO_TEST_SUITE(formulation)

using namespace Signorini;
using namespace dealii;

namespace
{
  using TestLaws::hencky, TestLaws::neo_hooke;

  const std::string &steel = TestLaws::linear;
  const std::string  all =
    TestLaws::armstrong_frederick + "set Rate dependence = Johnson-Cook\n";
  const std::string perfect = steel + "set Hardening modulus = 0\n";

  const auto both = {Kinematics::small_strain, Kinematics::finite_strain};

  // A point of a body in two dimensions.
  struct PlanePoint
  {
    PlanePoint(const std::string &entries,
               const Kinematics   kinematics,
               const Formulation  formulation)
      : formulation(formulation)
      , material(test_material(entries, kinematics))
      , history_n(n_history_values(formulation, *material))
      , history(history_n.size())
    {}

    PointResponse
    respond(const Tensor<2, 2> &gradient, const double hoop = 0.) const
    {
      return Signorini::respond(formulation,
                                *material,
                                gradient,
                                hoop,
                                {1e-2, {}},
                                make_array_view(history_n),
                                make_array_view(history));
    }

    PointResponse
    advance(const Tensor<2, 2> &gradient, const double hoop = 0.)
    {
      const PointResponse response = respond(gradient, hoop);
      history_n                    = history;
      return response;
    }

    Formulation                 formulation;
    std::unique_ptr<Material>   material;
    std::vector<double>         history_n;
    mutable std::vector<double> history;
  };

  Tensor<2, 2>
  plane_gradient(RandomDeformations &random, const double size)
  {
    Tensor<2, 2> result;
    for (unsigned int i = 0; i < 2; ++i)
      for (unsigned int j = 0; j < 2; ++j)
        result[i][j] = random.number(-size, size);
    return result;
  }
} // namespace



// Plane stress: no stress across the thickness, in steps of any size.
BOOST_AUTO_TEST_CASE(no_stress_across_the_thickness)
{
  for (const Kinematics kinematics : both)
    for (const std::string &entries : {hencky, neo_hooke, steel, perfect, all})
      for (const double size : {1e-12, 1e-4, 0.01, 0.1, 0.3})
        {
          RandomDeformations random(51);
          PlanePoint point(entries, kinematics, Formulation::plane_stress);
          double     worst = 0.;
          for (unsigned int step = 0; step < 20; ++step)
            {
              const auto response = point.advance(plane_gradient(random, size));
              worst               = std::max(worst,
                               std::abs(response.cauchy_stress[2][2]) /
                                 response.cauchy_stress.norm());
            }
          BOOST_TEST(worst < 1e-12);
        }
}



// What the search finds is what the material says to the strain found.
BOOST_AUTO_TEST_CASE(sheet_as_a_solid)
{
  for (const Kinematics kinematics : both)
    for (const std::string &entries : {hencky, neo_hooke, steel, all})
      {
        RandomDeformations  random(54);
        const auto          material = test_material(entries, kinematics);
        const unsigned int  n        = material->n_history_values();
        std::vector<double> history_n(n), history(n), expected_history(n);
        for (unsigned int step = 0; step < 10; ++step)
          {
            MaterialPoint point = {random.gradient(0.1, true),
                                   {1e-2, {}},
                                   make_array_view(history_n)};
            const auto    found =
              material->respond_in_plane_stress(point,
                                                make_array_view(history));
            const auto expected =
              material->respond(point, make_array_view(expected_history));
            BOOST_TEST(relative_difference(found.stress, expected.stress) <
                       1e-11);
            BOOST_TEST(relative_difference(found.tangent, expected.tangent) <
                       1e-10);
            BOOST_TEST(std::abs(found.energy_density / expected.energy_density -
                                1.) < 1e-11);
            for (unsigned int k = 0; k < n; ++k)
              BOOST_TEST(std::abs(history[k] - expected_history[k]) <=
                         1e-11 * std::abs(expected_history[k]) + 1e-15);
            history_n = history;
          }
      }
}



// Turned without strain: all stress is rounding, and the search has to end.
BOOST_AUTO_TEST_CASE(sheet_that_only_turns)
{
  for (const std::string &entries : {hencky, neo_hooke, steel, all})
    for (unsigned int degrees = 0; degrees < 360; ++degrees)
      {
        PlanePoint   point(entries,
                         Kinematics::finite_strain,
                         Formulation::plane_stress);
        const double angle = degrees * numbers::PI / 180.;
        Tensor<2, 2> gradient;
        gradient[0][0] = gradient[1][1] = std::cos(angle) - 1.;
        gradient[1][0]                  = std::sin(angle);
        gradient[0][1]                  = -gradient[1][0];
        // the strain is rounded to some 1e-16, the stiffness is 3e11 Pa
        BOOST_TEST(point.advance(gradient).cauchy_stress.norm() < 1e-3);
      }
}



// Uniaxial stress by two ways: plane stress with a free edge, and the material
// in space with free sides. Force per area of the start, as the element
// integrates it.
BOOST_AUTO_TEST_CASE(tension_of_a_sheet)
{
  for (const Kinematics kinematics : both)
    for (const std::string &entries : {hencky, neo_hooke, steel})
      {
        PlanePoint      sheet(entries, kinematics, Formulation::plane_stress);
        PointOfMaterial rod(entries, kinematics);
        double          lateral = 0.;
        for (const double stretch : {1.0005, 1.01, 1.1, 1.5, 1.2})
          {
            Tensor<2, 2> gradient;
            gradient[0][0] = stretch - 1.;
            for (unsigned int i = 0; i < 50; ++i)
              {
                gradient[1][1]        = lateral;
                const auto   response = sheet.respond(gradient);
                const double stress   = response.stress[1];
                if (std::abs(stress) < 1e-13 * std::abs(response.stress[0]))
                  break;
                const bool is_finite = kinematics == Kinematics::finite_strain;
                const double strain =
                  -stress /
                  (response.tangent[1][1] + (is_finite ? 2. * stress : 0.));
                lateral +=
                  is_finite ? (1. + lateral) * std::expm1(strain) : strain;
              }
            const auto found = sheet.advance(gradient);
            const auto truth = rod.stretch(stretch);
            BOOST_TEST(std::abs(found.stress[0] / truth.stress[0][0] - 1.) <
                       1e-11);
            BOOST_TEST(std::abs(lateral - rod.lateral) < 1e-13);
            const double J =
              kinematics == Kinematics::small_strain ?
                1. :
                stretch * (1. + rod.lateral) * (1. + rod.lateral);
            BOOST_TEST(
              std::abs(found.cauchy_stress[0][0] * J / truth.stress[0][0] -
                       1.) < 1e-11);
            BOOST_TEST(std::abs(found.energy_density / truth.energy_density -
                                1.) < 1e-11);
          }
      }
}



// The condensed tangent by differences.
BOOST_AUTO_TEST_CASE(condensed_tangent)
{
  for (const Kinematics kinematics : both)
    for (const std::string &entries : {hencky, neo_hooke, steel})
      {
        RandomDeformations random(52);
        PlanePoint   point(entries, kinematics, Formulation::plane_stress);
        const bool   is_finite = kinematics == Kinematics::finite_strain;
        const double h         = is_finite ? 2e-5 : 1e-5;
        double       worst     = 0.;
        for (unsigned int step = 0; step < 10; ++step)
          {
            const Tensor<2, 2> gradient = plane_gradient(random, 0.1);
            const auto         found    = point.respond(gradient);
            Tensor<2, 2>       stress;
            stress[0][0] = found.stress[0];
            stress[1][1] = found.stress[1];
            stress[0][1] = stress[1][0] = found.stress[2];
            for (unsigned int j = 0; j < 3; ++j)
              {
                Tensor<2, 2> d;
                if (j < 2)
                  d[j][j] = 1.;
                else
                  d[0][1] = d[1][0] = 0.5;
                const Tensor<2, 2> direction = is_finite ? d + d * gradient : d;
                const auto at = [&](const double s, const unsigned int i) {
                  return point.respond(gradient + s * h * direction).stress[i];
                };
                const Tensor<2, 2> convected = d * stress + stress * d;
                for (unsigned int i = 0; i < 3; ++i)
                  {
                    double rate = (8. * (at(1., i) - at(-1., i)) -
                                   (at(2., i) - at(-2., i))) /
                                  (12. * h);
                    if (is_finite)
                      rate -= i < 2 ? convected[i][i] : convected[0][1];
                    worst = std::max(worst,
                                     std::abs(rate - found.tangent[i][j]) /
                                       found.tangent[0][0]);
                  }
              }
            point.advance(gradient);
          }
        BOOST_TEST_MESSAGE("condensed tangent: " << worst);
        BOOST_TEST(worst < 1e-7);
      }
}



// The other formulations take what the material says.
BOOST_AUTO_TEST_CASE(gradients_in_space)
{
  RandomDeformations random(53);
  for (const Kinematics kinematics : both)
    for (const auto formulation :
         {Formulation::plane_strain, Formulation::axisymmetric})
      {
        PlanePoint      point(steel, kinematics, formulation);
        PointOfMaterial truth(steel, kinematics);
        const auto     &components = strain_components(formulation);
        for (unsigned int step = 0; step < 3; ++step)
          {
            const Tensor<2, 2> gradient = plane_gradient(random, 0.05);
            const double       hoop = formulation == Formulation::axisymmetric ?
                                        random.number(-0.05, 0.05) :
                                        0.;
            Tensor<2, 3>       full;
            for (unsigned int i = 0; i < 2; ++i)
              for (unsigned int j = 0; j < 2; ++j)
                full[i][j] = gradient[i][j];
            full[2][2]          = hoop;
            const auto found    = point.advance(gradient, hoop);
            const auto expected = truth.advance(full, 1e-2);
            for (unsigned int i = 0; i < components.size(); ++i)
              {
                const auto [a, b] = components[i];
                BOOST_TEST(found.stress[i] == expected.stress[a][b]);
                for (unsigned int j = 0; j < components.size(); ++j)
                  {
                    const auto [c, d] = components[j];
                    BOOST_TEST(found.tangent[i][j] ==
                               expected.tangent[a][b][c][d]);
                  }
              }
            const double J = kinematics == Kinematics::small_strain ?
                               1. :
                               determinant(unit_tensor() + full);
            BOOST_TEST(relative_difference(J * found.cauchy_stress,
                                           expected.stress) < 1e-14);
            BOOST_TEST(found.energy_density == expected.energy_density);
            BOOST_TEST(found.plastic_work_density ==
                       expected.plastic_work_density);
          }
      }
}



BOOST_AUTO_TEST_CASE(failures)
{
  const PlanePoint ring(hencky,
                        Kinematics::finite_strain,
                        Formulation::axisymmetric);
  Tensor<2, 2>     inverted;
  inverted[0][0] = -1.5;
  // Inverted in the plane and across it: the volume alone would not tell.
  BOOST_CHECK_THROW(ring.respond(inverted, -1.5), MaterialFailure);
  BOOST_CHECK_THROW(ring.respond(Tensor<2, 2>(), -1.), MaterialFailure);
  for (const std::string &entries : {hencky, neo_hooke})
    BOOST_CHECK_THROW(PlanePoint(entries,
                                 Kinematics::finite_strain,
                                 Formulation::plane_stress)
                        .respond(inverted),
                      MaterialFailure);
}

BOOST_AUTO_TEST_SUITE_END()
