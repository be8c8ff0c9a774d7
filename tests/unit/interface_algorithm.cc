#include <signorini/input/input_error.h>
#include <signorini/variational_inequality/interface_algorithm.h>

#include <deal.II/base/parameter_handler.h>

#include <boost/test/unit_test.hpp>

#include "interface_reference.h"

BOOST_AUTO_TEST_SUITE(interface_algorithm)

using namespace Signorini;

BOOST_AUTO_TEST_CASE(chosen_by_name)
{
  AlgorithmParameters parameters;
  parameters.penalty_stiffness = 1e9;
  for (const std::string name : {"ando",
                                 "two step",
                                 "semismooth Newton",
                                 "penalty",
                                 "augmented Lagrangian"})
    {
      parameters.algorithm = name;
      const auto algorithm = make_interface_algorithm(parameters);
      BOOST_TEST(algorithm->name() == name);
      BOOST_TEST(algorithm->enforces_exactly() ==
                 (name != "penalty" && name != "augmented Lagrangian"));
      BOOST_TEST(interface_algorithm_names().find(name) != std::string::npos);
    }

  parameters.algorithm = "guess";
  try
    {
      make_interface_algorithm(parameters);
      BOOST_ERROR("an unknown name was accepted");
    }
  catch (const InputError &error)
    {
      const std::string message = error.what();
      BOOST_TEST(message.find("`guess'") != std::string::npos);
      BOOST_TEST(message.find("penalty") != std::string::npos);
    }
}



BOOST_AUTO_TEST_CASE(entries)
{
  dealii::ParameterHandler prm;
  AlgorithmParameters::declare_parameters(prm);
  const AlgorithmParameters defaults = AlgorithmParameters::parse(prm);
  BOOST_TEST(defaults.algorithm == AlgorithmParameters().algorithm);
  BOOST_TEST(defaults.penalty_stiffness ==
             AlgorithmParameters().penalty_stiffness);
  BOOST_TEST(defaults.tangential_penalty_stiffness ==
             AlgorithmParameters().tangential_penalty_stiffness);
  BOOST_TEST(defaults.regularisation_slip ==
             AlgorithmParameters().regularisation_slip);
  BOOST_TEST(defaults.penetration_tolerance ==
             AlgorithmParameters().penetration_tolerance);
  BOOST_TEST(defaults.maximal_iterations ==
             AlgorithmParameters().maximal_iterations);

  prm.parse_input_from_string("set Algorithm = augmented Lagrangian\n"
                              "set Penalty stiffness = 2.5e9\n"
                              "set Tangential penalty stiffness = 3e9\n"
                              "set Regularisation slip = 1e-12\n"
                              "set Penetration tolerance = 1e-7\n"
                              "set Maximal iterations = 12\n");
  const AlgorithmParameters parameters = AlgorithmParameters::parse(prm);
  BOOST_TEST(parameters.algorithm == "augmented Lagrangian");
  BOOST_TEST(parameters.penalty_stiffness == 2.5e9);
  BOOST_TEST(parameters.tangential_penalty_stiffness == 3e9);
  BOOST_TEST(parameters.regularisation_slip == 1e-12);
  BOOST_TEST(parameters.penetration_tolerance == 1e-7);
  BOOST_TEST(parameters.maximal_iterations == 12);
}



BOOST_AUTO_TEST_CASE(open_contacts_need_no_algorithm)
{
  InterfaceProblem problem = InterfaceReference::make_problem(
    InterfaceReference::springs_over_floor(4, 1e-4));
  for (unsigned int k = 0; k < 4; ++k)
    problem.set_gap(k, 1.);
  AlgorithmParameters parameters;
  parameters.penalty_stiffness = 1e9;
  for (const std::string name : {"ando",
                                 "two step",
                                 "semismooth Newton",
                                 "penalty",
                                 "augmented Lagrangian"})
    {
      parameters.algorithm = name;
      const InterfaceSolution solution =
        make_interface_algorithm(parameters)
          ->solve(problem, InterfaceForces({1., 0., 2., 0.}));
      BOOST_TEST(solution.n_iterations == 0);
      BOOST_TEST((solution.forces.normal == std::vector<double>(4, 0.)));
      BOOST_TEST((solution.displacement == problem.free_displacement()));
    }
}

BOOST_AUTO_TEST_SUITE_END()
