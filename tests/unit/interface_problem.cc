#include <signorini/input/input_error.h>
#include <signorini/variational_inequality/interface_problem.h>
#include <signorini/variational_inequality/interface_problem_io.h>

#include <boost/test/unit_test.hpp>

#include <sstream>

#include "interface_reference.h"

BOOST_AUTO_TEST_SUITE(interface_problem)

using namespace Signorini;
using dealii::FullMatrix;
using dealii::Vector;

namespace
{
  FullMatrix<double>
  diagonal(const std::vector<double> &entries)
  {
    FullMatrix<double> matrix(entries.size(), entries.size());
    for (unsigned int i = 0; i < entries.size(); ++i)
      matrix(i, i) = entries[i];
    return matrix;
  }

  // S = diag(2, 4), r = (6, 8), A = [1 1; 0 -1], G = (1, 0.5).
  InterfaceProblem
  small()
  {
    InterfaceProblem problem;
    problem.set_stiffness(InterfaceStiffness::from_matrix(diagonal({2., 4.})));
    Vector<double> force(2);
    force(0) = 6.;
    force(1) = 8.;
    problem.set_force(force);
    problem.set_contacts({{{{0, 1.}, {1, 1.}}, 1.}, {{{1, -1.}}, 0.5}});
    return problem;
  }

  constexpr double rounding = 1e-15;

  std::string
  as_text(const InterfaceProblem &problem)
  {
    std::ostringstream text;
    write_interface_problem(problem, text);
    return text.str();
  }

  InterfaceProblem
  from_text(const std::string &text)
  {
    std::istringstream stream(text);
    return read_interface_problem(stream, "the test");
  }

  std::string
  replaced(std::string        text,
           const std::string &what,
           const std::string &replacement)
  {
    BOOST_REQUIRE(text.find(what) != std::string::npos);
    return text.replace(text.find(what), what.size(), replacement);
  }
} // namespace



BOOST_AUTO_TEST_CASE(derived_values_by_hand)
{
  const InterfaceProblem problem = small();
  BOOST_TEST(problem.size() == 2);
  BOOST_TEST(problem.n_contacts() == 2);
  BOOST_TEST(std::abs(problem.free_displacement()(0) - 3.) <= 3. * rounding);
  BOOST_TEST(std::abs(problem.free_displacement()(1) - 2.) <= 2. * rounding);
  BOOST_TEST(std::abs(problem.free_gaps()[0] + 4.) <= 5. * rounding);
  BOOST_TEST(std::abs(problem.free_gaps()[1] - 2.5) <= 5. * rounding);
  BOOST_TEST(std::abs(problem.compliance(0, 0) - 0.75) <= rounding);
  BOOST_TEST(std::abs(problem.compliance(0, 1) + 0.25) <= rounding);
  BOOST_TEST(std::abs(problem.compliance(1, 0) + 0.25) <= rounding);
  BOOST_TEST(std::abs(problem.compliance(1, 1) - 0.25) <= rounding);
}



BOOST_AUTO_TEST_CASE(force_in_terms_of_the_factor)
{
  std::mt19937     generator(11);
  const auto       data = InterfaceReference::random_problem(6, 4, generator);
  InterfaceProblem problem           = InterfaceReference::make_problem(data);
  const Vector<double>      expected = problem.free_displacement();
  const std::vector<double> expected_gaps = problem.free_gaps();

  Vector<double> y = data.force;
  problem.stiffness().solve_factor(y);
  Vector<double> zero(6);
  problem.set_force(zero);
  BOOST_TEST(problem.free_displacement().l2_norm() == 0.);
  problem.set_reduced_force(y);
  for (unsigned int i = 0; i < 6; ++i)
    {
      BOOST_TEST(std::abs(problem.force()(i) - data.force(i)) <= 1e-13);
      BOOST_TEST(problem.free_displacement()(i) == expected(i));
    }
  for (unsigned int k = 0; k < 4; ++k)
    BOOST_TEST(problem.free_gaps()[k] == expected_gaps[k]);
}



BOOST_AUTO_TEST_CASE(responses_are_kept_as_long_as_they_hold)
{
  InterfaceProblem problem = small();
  BOOST_TEST(!problem.knows_response(0));
  BOOST_TEST(std::abs(problem.response(0)(1) - 0.25) <= rounding);
  BOOST_TEST(std::abs(problem.response(1)(1) + 0.25) <= rounding);
  BOOST_TEST(std::abs(problem.free_gaps()[0] + 4.) <= 5. * rounding);

  // 1. Other gaps and forces, the same rows: kept.
  problem.set_gap(0, 2.);
  BOOST_TEST(problem.knows_response(0));
  BOOST_TEST(std::abs(problem.free_gaps()[0] + 3.) <= 5. * rounding);
  problem.set_force(Vector<double>(2));
  BOOST_TEST(problem.free_gaps()[0] == 2.);
  problem.set_contacts({{{{0, 1.}, {1, 1.}}, 7.}, {{{1, -1.}}, 0.}});
  BOOST_TEST(problem.knows_response(0));
  BOOST_TEST(problem.knows_response(1));
  BOOST_TEST(problem.free_gaps()[0] == 7.);

  // 2. One row changes: only its response does.
  problem.set_contacts({{{{0, 1.}, {1, 1.}}, 7.}, {{{1, -2.}}, 0.}});
  BOOST_TEST(problem.knows_response(0));
  BOOST_TEST(!problem.knows_response(1));
  BOOST_TEST(std::abs(problem.response(1)(1) + 0.5) <= rounding);

  // 3. A contact goes and comes again as another.
  problem.set_contacts({{{{0, 1.}, {1, 1.}}, 7.}});
  BOOST_TEST(problem.knows_response(0));
  problem.set_contacts({{{{0, 1.}, {1, 1.}}, 7.}, {{{0, -2.}}, 0.}});
  BOOST_TEST(!problem.knows_response(1));
  BOOST_TEST(std::abs(problem.response(1)(0) + 1.) <= rounding);

  // 4. Another stiffness: all change, in one block.
  problem.set_stiffness(InterfaceStiffness::from_matrix(diagonal({4., 8.})));
  BOOST_TEST(!problem.knows_response(0));
  BOOST_TEST(!problem.knows_response(1));
  problem.set_force(Vector<double>(2));
  problem.prepare_responses({1, 0});
  BOOST_TEST(problem.knows_response(0));
  BOOST_TEST(std::abs(problem.response(0)(0) - 0.25) <= rounding);
  BOOST_TEST(std::abs(problem.response(0)(1) - 0.125) <= rounding);
  BOOST_TEST(std::abs(problem.response(1)(0) + 0.5) <= rounding);
}



BOOST_AUTO_TEST_CASE(tangents_and_the_matrix_of_compliances)
{
  InterfaceProblem problem = small();
  auto             contacts =
    std::vector<InterfaceContact>{problem.contact(0), problem.contact(1)};
  contacts[0].tangents             = {{{0, 1.}, {1, -1.}}};
  contacts[0].friction_coefficient = 0.3;
  problem.set_contacts(contacts);
  BOOST_TEST(!problem.knows_tangent_response(0, 0));
  BOOST_TEST(std::abs(problem.tangent_response(0, 0)(0) - 0.5) <= rounding);
  BOOST_TEST(std::abs(problem.tangent_response(0, 0)(1) + 0.25) <= rounding);

  // 1. Rows in the order asked for: contact 1, then 0 with its tangent.
  const auto check = [&](const std::vector<std::vector<double>> &expected,
                         const bool                              friction) {
    const auto &W = problem.compliance_matrix({1, 0}, friction).matrix();
    BOOST_REQUIRE(W.m() == expected.size());
    for (unsigned int i = 0; i < W.m(); ++i)
      for (unsigned int j = 0; j < W.m(); ++j)
        BOOST_TEST(std::abs(W(i, j) - expected[i][j]) <= rounding);
  };
  check({{0.25, -0.25, 0.25}, {-0.25, 0.75, 0.25}, {0.25, 0.25, 0.75}}, true);
  check({{0.25, -0.25}, {-0.25, 0.75}}, false);

  // 2. Gaps and slips change nothing; a tangent does, and only its response.
  problem.set_slip(0, {{0.5, 0.}});
  problem.set_gap(0, 3.);
  BOOST_TEST(problem.slip_after(0, 0, Vector<double>(2)) == 0.5);
  problem.set_contacts(contacts);
  BOOST_TEST(problem.knows_tangent_response(0, 0));
  contacts[0].tangents[0] = {{0, 2.}};
  problem.set_contacts(contacts);
  BOOST_TEST(problem.knows_response(0));
  BOOST_TEST(!problem.knows_tangent_response(0, 0));
  check({{0.25, -0.25, 0.}, {-0.25, 0.75, 1.}, {0., 1., 2.}}, true);

  // 3. Another stiffness.
  problem.set_stiffness(InterfaceStiffness::from_matrix(diagonal({4., 8.})));
  BOOST_TEST(!problem.knows_tangent_response(0, 0));
  check({{0.125, -0.125, 0.}, {-0.125, 0.375, 0.5}, {0., 0.5, 1.}}, true);
}



BOOST_AUTO_TEST_CASE(text_round_trip_is_exact)
{
  std::mt19937 generator(5);
  auto         data = InterfaceReference::random_problem(7, 5, generator);
  data.stiffness *= 1e9 / 3.;
  data.force *= 1e-7 / 3.;
  data.contacts[0].gap      = 1e-300;
  data.contacts[1]          = InterfaceContact{};
  data.contacts[1].gap      = std::numeric_limits<double>::infinity();
  data.contacts[2].tangents = {{{0, 1. / 3.}}, {{1, 2.}, {6, -1e-9}}};
  data.contacts[2].slip     = {{1e-5 / 3., -2.}};
  data.contacts[2].friction_coefficient = 0.1;
  data.contacts[3].tangents             = {{{4, -1.}}};
  data.contacts[3].friction_coefficient = 1. / 7.;
  data.contacts[3].largest_friction     = 1e6 / 3.;
  const InterfaceProblem original = InterfaceReference::make_problem(data);
  const InterfaceProblem copy     = from_text(as_text(original));

  BOOST_TEST(copy.size() == original.size());
  BOOST_REQUIRE(copy.n_contacts() == original.n_contacts());
  for (unsigned int i = 0; i < 7; ++i)
    {
      BOOST_TEST(copy.force()(i) == original.force()(i));
      BOOST_TEST(copy.free_displacement()(i) ==
                 original.free_displacement()(i));
      for (unsigned int j = 0; j <= i; ++j)
        BOOST_TEST(copy.stiffness().factor(i, j) ==
                   original.stiffness().factor(i, j));
    }
  for (unsigned int k = 0; k < 5; ++k)
    {
      BOOST_TEST(copy.contact(k).gap == original.contact(k).gap);
      BOOST_TEST((copy.contact(k).normal == original.contact(k).normal));
      BOOST_TEST((copy.contact(k).tangents == original.contact(k).tangents));
      BOOST_TEST((copy.contact(k).slip == original.contact(k).slip));
      BOOST_TEST(copy.contact(k).friction_coefficient ==
                 original.contact(k).friction_coefficient);
      BOOST_TEST(copy.contact(k).largest_friction ==
                 original.contact(k).largest_friction);
    }
  BOOST_TEST(as_text(copy) == as_text(original));
}



BOOST_AUTO_TEST_CASE(damaged_text_is_refused)
{
  const std::string text = as_text(small());
  BOOST_TEST(from_text(text).n_contacts() == 2);
  const auto refuses = [&](const std::string &what,
                           const std::string &replacement,
                           const std::string &named) {
    try
      {
        from_text(replaced(text, what, replacement));
        BOOST_ERROR("accepted: " << replacement);
      }
    catch (const InputError &error)
      {
        const std::string message = error.what();
        BOOST_TEST(message.find("the test") != std::string::npos);
        BOOST_TEST(message.find(named) != std::string::npos, message);
      }
  };
  refuses("Signorini", "Hertz", "first line");
  refuses("size 2", "size -2", "size");
  refuses("size 2", "size 2000000000", "size");
  refuses("contacts 2", "contacts two", "contacts");
  refuses("force", "froce", "`force'");
  refuses("0.5 1 1 -1", "0.5 1 2 -1", "a DoF");
  refuses("0.5 1 1 -1", "0.5 1 1 x", "a coefficient");
  refuses("0.5 1 1 -1", "nan 1 1 -1", "a gap");
  refuses("0.5 1 1 -1", "-inf 1 1 -1", "a gap");
  refuses("0 inf 0", "inf inf 0", "a friction coefficient");
  refuses("0 inf 0", "-0.1 inf 0", "a friction coefficient");
  refuses("0 inf 0", "0 -1 0", "a largest friction");
  refuses("0 inf 0", "0 inf 3", "a number of tangents");
  refuses("0 inf 0", "0 inf 1 0.1x", "a slip");
  refuses("problem 2", "problem 1", "first line");
  refuses("factor\n1", "factor\n-1", "diagonal");
  refuses("end", "", "`end'");
}

BOOST_AUTO_TEST_SUITE_END()
