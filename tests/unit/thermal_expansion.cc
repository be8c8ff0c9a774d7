#include <boost/test/unit_test.hpp>

#include "material_point.h"

BOOST_AUTO_TEST_SUITE(thermal_expansion)

using namespace Signorini;
using namespace dealii;

namespace
{
  constexpr double E = 2e9, nu = 0.3, alpha = 1e-4, reference = 20.;

  const std::string entries =
    "set Young's modulus = 2e9\nset Poisson's ratio = 0.3\n"
    "set Thermal expansion = 1e-4\nset Reference temperature = 20\n";

  // A point that is heated step by step.
  struct HeatedPoint
  {
    explicit HeatedPoint(const Kinematics   kinematics,
                         const std::string &law = "elastic")
      : material(test_material("set Law = " + law + "\n" + entries, kinematics))
      , history_n(material->n_history_values())
      , history(history_n)
    {}

    MaterialResponse
    step(const Tensor<2, 3> &gradient, const std::optional<double> temperature)
    {
      const auto response = material->respond({gradient,
                                               {1., temperature},
                                               make_array_view(history_n)},
                                              make_array_view(history));
      history_n           = history;
      return response;
    }

    std::unique_ptr<Material> material;
    std::vector<double>       history_n, history;
  };

  Tensor<2, 3>
  uniform(const double strain)
  {
    return strain * Tensor<2, 3>(unit_symmetric_tensor<3>());
  }
} // namespace



// What expands freely has no stress, whatever the law.
BOOST_AUTO_TEST_CASE(free_expansion)
{
  for (const char *const law : {"elastic", "neo-Hooke", "elasto-plastic"})
    {
      HeatedPoint small(Kinematics::small_strain, law);
      BOOST_TEST(
        small.step(uniform(alpha * 50.), reference + 50.).stress.norm() <
        1e-12 * E);
      HeatedPoint finite(Kinematics::finite_strain, law);
      const auto  found =
        finite.step(uniform(std::expm1(alpha * 50.)), reference + 50.);
      BOOST_TEST(found.stress.norm() < 1e-12 * E);
      BOOST_TEST(found.energy_density < 1e-12);
    }
}



// What cannot expand has the pressure 3 K alpha dT, and the energy that it
// stores came from heating. At rest it remembers its temperature.
BOOST_AUTO_TEST_CASE(held)
{
  for (const Kinematics kinematics :
       {Kinematics::small_strain, Kinematics::finite_strain})
    {
      HeatedPoint point(kinematics);
      point.step({}, reference + 30.);
      const auto   found    = point.step({}, reference + 100.);
      const double pressure = E / (1. - 2. * nu) * alpha * 100.;
      for (unsigned int i = 0; i < 3; ++i)
        BOOST_TEST(std::abs(found.stress[i][i] / -pressure - 1.) < 1e-12);
      BOOST_TEST(
        std::abs(found.energy_density / (1.5 * pressure * alpha * 100.) - 1.) <
        1e-12);
      BOOST_TEST(std::abs(found.heating_density / found.energy_density - 1.) <
                 1e-12);
      const auto at_rest = point.step({}, std::nullopt);
      BOOST_TEST((at_rest.stress - found.stress).norm() < 1e-12 * pressure);
      BOOST_TEST(at_rest.heating_density == found.heating_density);
    }
}



// A sheet is free across.
BOOST_AUTO_TEST_CASE(held_sheet)
{
  for (const Kinematics kinematics :
       {Kinematics::small_strain, Kinematics::finite_strain})
    {
      HeatedPoint   point(kinematics);
      MaterialPoint sheet = {Tensor<2, 3>(),
                             {1., reference + 100.},
                             make_array_view(point.history_n)};
      const auto    found =
        point.material->respond_in_plane_stress(sheet,
                                                make_array_view(point.history));
      BOOST_TEST(std::abs(found.stress[0][0] / (-E / (1. - nu) * alpha * 100.) -
                          1.) < 1e-12);
      const double across = alpha * 100. * (1. + 2. * nu / (1. - nu));
      BOOST_TEST(std::abs(sheet.gradient[2][2] /
                            (kinematics == Kinematics::small_strain ?
                               across :
                               std::expm1(across)) -
                          1.) < 1e-12);
    }
}

// Nor has a sheet that expands freely, however close the first guess of its
// strain across is: all digits are found.
BOOST_AUTO_TEST_CASE(free_sheet)
{
  for (const double error : {1e-12, -3e-13, 1e-13, 1e-15})
    {
      HeatedPoint   point(Kinematics::small_strain);
      MaterialPoint sheet = {uniform(alpha * 50.),
                             {1., reference + 50.},
                             make_array_view(point.history_n)};
      sheet.gradient[2][2] += error;
      const auto found =
        point.material->respond_in_plane_stress(sheet,
                                                make_array_view(point.history));
      BOOST_TEST(found.stress.norm() < 1e-16 * E);
    }
}

BOOST_AUTO_TEST_SUITE_END()
