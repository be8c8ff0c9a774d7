#include <signorini/input/input_error.h>
#include <signorini/output/expected_results.h>

#include <boost/test/unit_test.hpp>

#include <cmath>

#include "contains.h"

BOOST_AUTO_TEST_SUITE(expected_results, *boost::unit_test::tolerance(1e-14))

using namespace Signorini;

namespace
{
  // A body that touches at 1 s, leaves at 3 s and touches again at 4 s.
  History
  example()
  {
    History history;
    history.add_column("floor.contacts", "");
    history.add_column("tip.displacement_y", "m");
    history.append_row({0., 0., 0.});
    history.append_row({1., 2., -1e-5});
    history.append_row({2., 1., -4e-5});
    history.append_row({3., 0., 2e-5});
    history.append_row({4., 3., -1e-5});
    return history;
  }

  // von_mises = 10 x + y on the corners of the square (0, 2)^2.
  class SquareFields : public FieldLookup
  {
  public:
    std::vector<std::string>
    names() const override
    {
      return {"beam.von_mises"};
    }

    NodalField
    field(const std::string &) const override
    {
      return {{{0., 0., 0.}, {2., 0., 0.}, {0., 2., 0.}, {2., 3., 0.5}},
              {0., 20., 2., 22.}};
    }
  };

  double
  value(const std::string &text)
  {
    return CheckExpression(text).evaluate(example(), SquareFields());
  }

  CheckResult
  result(const std::string &check)
  {
    const auto results =
      ExpectedResults(check).evaluate(example(), SquareFields());
    BOOST_REQUIRE(results.size() == 1u);
    return results[0];
  }

  bool
  passes(const std::string &check)
  {
    return result(check).passed;
  }

  // The message of the error, or nothing.
  std::string
  syntax_error(const std::string &checks)
  {
    try
      {
        ExpectedResults(checks).check_names(example(), SquareFields());
      }
    catch (const InputError &error)
      {
        return error.what();
      }
    return "";
  }
} // namespace



BOOST_AUTO_TEST_CASE(functions_of_columns)
{
  BOOST_TEST(value("max(tip.displacement_y)") == 2e-5);
  BOOST_TEST(value("min(tip.displacement_y)") == -4e-5);
  BOOST_TEST(value("max_abs(tip.displacement_y)") == 4e-5);
  BOOST_TEST(value("final(tip.displacement_y)") == -1e-5);
  BOOST_TEST(value("mean(floor.contacts)") == 4.5 / 4.);
  BOOST_TEST(value("at(tip.displacement_y, 1.5)") == -2.5e-5);
  BOOST_TEST(value("final(time)") == 4.);
}

BOOST_AUTO_TEST_CASE(time_windows)
{
  BOOST_TEST(value("max(floor.contacts, 1.5, 3.5)") == 1.);
  BOOST_TEST(value("min(floor.contacts, 1, 2)") == 1.);
  BOOST_TEST(value("max_abs(tip.displacement_y, 0, 1)") == 1e-5);
  BOOST_TEST(value("final(floor.contacts, 0, 2)") == 1.);
  // Linear from 2 to 1 to 0: mean 1 over 1 s to 3 s.
  BOOST_TEST(value("mean(floor.contacts, 1, 3)") == 1.);
}

BOOST_AUTO_TEST_CASE(functions_of_conditions)
{
  BOOST_TEST(value("first(floor.contacts > 0)") == 1.);
  BOOST_TEST(value("first(floor.contacts>=3)") == 4.);
  BOOST_TEST(value("last(floor.contacts < 1)") == 3.);
  BOOST_TEST(value("last(floor.contacts <= 1)") == 3.);
  BOOST_TEST(value("last(tip.displacement_y < -2*1e-5)") == 2.);
  BOOST_TEST(value("switches(floor.contacts > 0)") == 3.);
  BOOST_TEST(value("time(floor.contacts > 0, switch 1)") == 1.);
  BOOST_TEST(value("time(floor.contacts > 0, switch 2)") == 3.);
  BOOST_TEST(value("time( floor.contacts > 0 ,switch  3)") == 4.);
  // True at the first row already.
  BOOST_TEST(value("time(floor.contacts < 1, switch 1)") == 0.);
}

BOOST_AUTO_TEST_CASE(functions_of_fields)
{
  BOOST_TEST(value("field_max(beam.von_mises)") == 22.);
  BOOST_TEST(value("field_min(beam.von_mises)") == 0.);
  BOOST_TEST(value("x_of_max(beam.von_mises)") == 2.);
  BOOST_TEST(value("y_of_max(beam.von_mises)") == 3.);
  BOOST_TEST(value("z_of_max(beam.von_mises)") == 0.5);
  BOOST_TEST(value("x_of_min(beam.von_mises)") == 0.);
  BOOST_TEST(value("field(beam.von_mises, 1.9, 0.2)") == 20.);
  BOOST_TEST(value("field(beam.von_mises, 0.9, 1.1, 0)") == 2.);
}

BOOST_AUTO_TEST_CASE(formulas)
{
  BOOST_TEST(value("max_abs(tip.displacement_y)/4e-5") == 1.);
  BOOST_TEST(value("1e3*0.2^3/(3*73e9*6.667e-7)") ==
             1e3 * 0.008 / (3. * 73e9 * 6.667e-7));
  BOOST_TEST(value("sqrt(max(floor.contacts) + 1) - 2*cos(pi)") == 4.);
  BOOST_TEST(value("-max(floor.contacts) + 1.e+1") == 7.);
  // Calls within the arguments of calls.
  BOOST_TEST(value("at(tip.displacement_y, 1 + first(floor.contacts > 0))") ==
             -4e-5);
  // More than ten calls, so that call_1 and call_10 are kept apart.
  std::string sum = "max(floor.contacts)";
  for (unsigned int i = 0; i < 11; ++i)
    sum += " + 10*max(floor.contacts)";
  BOOST_TEST(value(sum) == 333.);
}

BOOST_AUTO_TEST_CASE(tolerances)
{
  BOOST_TEST(passes("max(floor.contacts) = 2.5 +- 0.5"));
  BOOST_TEST(!passes("max(floor.contacts) = 2.5 +- 0.49"));
  BOOST_TEST(passes("max(floor.contacts) = 3 +- 0"));
  // Relative to the right side and its absolute value.
  BOOST_TEST(passes("min(tip.displacement_y) = -5e-5 +- 20.1 %"));
  BOOST_TEST(!passes("min(tip.displacement_y) = -5e-5 +- 19.9%"));
  BOOST_TEST(passes("2*max(floor.contacts) = 2*final(floor.contacts) +- 0"));
  BOOST_TEST(passes("max(floor.contacts) = 3 +- 1e-3/2"));
}

BOOST_AUTO_TEST_CASE(inequalities)
{
  BOOST_TEST(passes("max(floor.contacts) < 3.1"));
  BOOST_TEST(!passes("max(floor.contacts) < 3"));
  BOOST_TEST(passes("max(floor.contacts) <= 3"));
  BOOST_TEST(passes("max(floor.contacts) > 2.9"));
  BOOST_TEST(!passes("max(floor.contacts) > 3"));
  BOOST_TEST(passes("max(floor.contacts) >= 3"));
  BOOST_TEST(passes("first(floor.contacts > 0) < last(floor.contacts > 0)"));
}

BOOST_AUTO_TEST_CASE(quantities_the_run_does_not_have_are_misses)
{
  for (const std::string left : {"first(floor.contacts > 7)",
                                 "time(floor.contacts > 0, switch 4)",
                                 "max(floor.contacts, 3, 5)",
                                 "max(floor.contacts, 3, 2)",
                                 "max(floor.contacts, 1.2, 1.8)",
                                 "at(floor.contacts, 4.5)",
                                 "1/min(floor.contacts)",
                                 "sqrt(min(tip.displacement_y))"})
    {
      BOOST_TEST(!passes(left + " < 1e300"));
      BOOST_TEST(!result(left + " < 1e300").reason.empty());
    }
  History empty;
  empty.add_column("a", "m");
  const auto results =
    ExpectedResults("max(a) < 1").evaluate(empty, NoFields());
  BOOST_TEST(!results[0].passed);
}

BOOST_AUTO_TEST_CASE(a_list_and_its_report)
{
  const ExpectedResults checks(
    " max(floor.contacts) = 3 +- 1 % |\n first(floor.contacts > 0) = 1.5 +- "
    "0.25 | first(floor.contacts > 9) > 0 | max(floor.contacts) < 4 | ");
  BOOST_TEST(checks.n_checks() == 4u);
  const auto results = checks.evaluate(example(), NoFields());
  BOOST_TEST(!all_passed(results));
  BOOST_TEST(all_passed({results[0], results[3]}));
  BOOST_TEST(report(results) ==
             "passed  max(floor.contacts) = 3 +- 1 %   found 3, expected 3, "
             "distance 0, tolerance 0.03\n"
             "missed  first(floor.contacts > 0) = 1.5 +- 0.25   found 1, "
             "expected 1.5, distance 0.5, tolerance 0.25\n"
             "missed  first(floor.contacts > 9) > 0   the condition never "
             "holds\n"
             "passed  max(floor.contacts) < 4   found 3, expected 4\n");
  BOOST_TEST(ExpectedResults("").n_checks() == 0u);
  BOOST_TEST(ExpectedResults(" \n").n_checks() == 0u);
}

BOOST_AUTO_TEST_CASE(names_and_sources)
{
  const ExpectedResults checks(
    "most contacts: max(floor.contacts) = 3 +- 1 % [Key, eq. (2)] | "
    "max(floor.contacts) < 2 [a: b] | (1 > 0 ? 3 : 2) = 3 +- 0");
  const auto results = checks.evaluate(example(), NoFields());
  BOOST_TEST(report(results) ==
             "passed  most contacts: max(floor.contacts) = 3 +- 1 % [Key, eq. "
             "(2)]   found 3, expected 3, distance 0, tolerance 0.03\n"
             "missed  max(floor.contacts) < 2 [a: b]   found 3, expected 2\n"
             "passed  (1 > 0 ? 3 : 2) = 3 +- 0   found 3, expected 3, distance "
             "0, tolerance 0\n");
  BOOST_TEST(syntax_error("a: max(time) > 0 | b: 1 > 0 | a: 2 > 1") ==
             "In the expected result 'a: 2 > 1': There is another one of this "
             "name.");
  BOOST_TEST(syntax_error(": 1 > 0") ==
             "In the expected result ': 1 > 0': There is no name in front of "
             "the colon.");
}

BOOST_AUTO_TEST_CASE(constants_in_checks)
{
  const Constants constants = {{"most", 3.}, {"tol", 0.5}, {"t0", 1.}};
  BOOST_TEST(
    all_passed(ExpectedResults("max(floor.contacts) = most +- tol % | "
                               "max(floor.contacts)*most = -3*(-most) +- 0 | "
                               "first(floor.contacts > most - 3) = t0 +- 1e-12",
                               constants)
                 .evaluate(example(), NoFields())));
  BOOST_CHECK_EXCEPTION(ExpectedResults("max(time) < mos", constants),
                        InputError,
                        [](const InputError &error) {
                          return contains(error.what(),
                                          "The constants are most, t0, tol. "
                                          "Did you mean \"most\"?");
                        });
}

BOOST_AUTO_TEST_CASE(unknown_names_are_found_before_the_run)
{
  History columns;
  columns.add_column("floor.contacts", "");
  const auto is_clear = [](const InputError &error) {
    return contains(error.what(),
                    "In the expected result 'max(floor.contact)") &&
           contains(error.what(), "Did you mean 'floor.contacts'?") &&
           contains(error.what(), "There are: time, floor.contacts.");
  };
  BOOST_CHECK_EXCEPTION(ExpectedResults("max(floor.contact) = 1 +- 1")
                          .check_names(columns, NoFields()),
                        InputError,
                        is_clear);
  BOOST_CHECK_NO_THROW(ExpectedResults("max(floor.contacts) = 1 +- 1")
                         .check_names(columns, NoFields()));
  // On the right, in arguments and thresholds, and of fields.
  BOOST_TEST(contains(syntax_error("1 = max(wrong) +- 1"), "'wrong'"));
  BOOST_TEST(contains(syntax_error("at(time, max(wrong)) < 1"), "'wrong'"));
  BOOST_TEST(contains(syntax_error("first(time > max(wrong)) < 1"), "'wrong'"));
  BOOST_TEST(
    contains(syntax_error("field_max(wrong) < 1"), "no field 'wrong'"));
  BOOST_TEST(
    contains(syntax_error("field_max(beam.vonmises) < 1"), "beam.von_mises"));
}

BOOST_AUTO_TEST_CASE(mistakes_in_the_syntax)
{
  BOOST_TEST(syntax_error("max(time) = 1 +- 1") == "");
  const std::vector<std::pair<std::string, std::string>> cases = {
    {"max(time) = 1", "needs a tolerance"},
    {"max(time) < 1 +- 1", "Only an equation"},
    {"max(time)", "exactly one of"},
    {"max(time) == 1 +- 1", "exactly one of"},
    {"1 < max(time) < 2", "exactly one of"},
    {"max(time) = 1 +- -1", "not negative"},
    {"max(time) = 1 +- max(time)", "not negative"},
    {"max(time) = 1 +- ", "missing"},
    {"max(time) = 1 +- %", "missing"},
    {"max(time) = 0 +- 1 %", "A tolerance in % of 0"},
    {"max(time) = +- 1", "missing"},
    {"= 1 +- 1", "missing"},
    {"max(time = 1 +- 1", "closing parenthesis is missing"},
    {"max(time)) = 1 +- 1", "too many"},
    {"time = 1 +- 1", "max(time)"},
    {"maximum(time) = 1 +- 1", "'time' is not a number"},
    {"max() < 1", "max(column) or max(column, t0, t1)"},
    {"max(time, 1) < 1", "max(column) or max(column, t0, t1)"},
    {"at(time) < 1", "at(column, t)"},
    {"field(beam.von_mises, 1) < 1", "field(field, x, y)"},
    {"first(time) < 1", "is not a condition"},
    {"first(0 < time < 1) < 1", "is not a condition"},
    {"first(time > ) < 1", "missing"},
    {"time(time > 0, 1) < 1", "the word switch"},
    {"time(time > 0, switch 0) < 1", "counted 1, 2"},
    {"time(time > 0, switch 1.5) < 1", "counted 1, 2"},
    {"max(time) 2 = 1 +- 1", "muParser"},
    {"max(time) * = 1 +- 1", "muParser"},
    {"sinus(1) = 1 +- 1", "muParser"},
    {"x = 1 +- 1", "'x' is not a number"},
    {"call_0 + max(time) = 1 +- 1", "'call_0' is not a number"}};
  for (const auto &[check, message] : cases)
    {
      const std::string error = syntax_error("max(time) < 9 | " + check);
      BOOST_TEST(contains(error, message), check << " gave: " << error);
      BOOST_TEST(contains(error, "In the expected result '"),
                 check << " gave: " << error);
    }
}

BOOST_AUTO_TEST_SUITE_END()
