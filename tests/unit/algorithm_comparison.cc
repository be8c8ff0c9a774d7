#include <signorini/input/input_error.h>
#include <signorini/variational_inequality/algorithm_comparison.h>
#include <signorini/variational_inequality/interface_problem_io.h>

#include <boost/test/unit_test.hpp>

#include <fstream>
#include <random>
#include <sstream>

#include "friction_reference.h"
#include "temporary_folder.h"

BOOST_AUTO_TEST_SUITE(algorithm_comparison)

using namespace Signorini;

namespace
{
  unsigned int
  n_lines_with(const std::string &text, const std::string &part)
  {
    std::istringstream lines(text);
    unsigned int       n = 0;
    for (std::string line; std::getline(lines, line);)
      n += line.find(part) != std::string::npos;
    return n;
  }
} // namespace



BOOST_AUTO_TEST_CASE(a_row_for_each_exact_algorithm)
{
  std::mt19937 generator(3);
  auto         data    = FrictionReference::random_problem(3, 3, generator);
  data.contacts[0].gap = -3.;
  for (InterfaceContact &contact : data.contacts)
    contact.friction_coefficient = 0.2;
  const std::string table =
    compare_algorithms(InterfaceReference::make_problem(data));
  BOOST_TEST(n_lines_with(table, "ando") == 1);
  BOOST_TEST(n_lines_with(table, "two step") == 1);
  BOOST_TEST(n_lines_with(table, "semismooth Newton") == 1);
  BOOST_TEST(n_lines_with(table, "penalty") == 0);
  BOOST_TEST(n_lines_with(table, "0.00e+00") >= 1); // the reference itself
  BOOST_TEST(n_lines_with(table, "") == 4);
}



BOOST_AUTO_TEST_CASE(failures_stand_in_the_table)
{
  std::mt19937 generator(3);
  auto data = FrictionReference::random_spatial_problem(2, 2, false, generator);
  data.contacts[0].gap = -3.;
  const std::string table =
    compare_algorithms(InterfaceReference::make_problem(data));
  BOOST_TEST(n_lines_with(table, "Use `semismooth Newton'") == 2);
  BOOST_TEST(n_lines_with(table, "e-1") == 1);
}



BOOST_AUTO_TEST_CASE(files)
{
  const TemporaryFolder folder;
  const std::string     path = folder.file("problem.txt");
  std::mt19937          generator(5);
  const auto data = FrictionReference::random_problem(3, 2, generator);
  {
    std::ofstream file(path);
    write_interface_problem(InterfaceReference::make_problem(data), file);
  }
  const std::string text = compare_algorithms_on_file(path);
  BOOST_TEST(text.find(path + ": 6 unknowns, 2 contacts") == 0U, text);

  BOOST_CHECK_THROW(compare_algorithms_on_file(folder.file("nothing")),
                    InputError);
  {
    std::ofstream file(path);
    file << "Signorini interface problem 2\nsize 3\nrubbish";
  }
  BOOST_CHECK_THROW(compare_algorithms_on_file(path), InputError);
}

BOOST_AUTO_TEST_SUITE_END()
