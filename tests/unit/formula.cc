#include <signorini/input/formula.h>
#include <signorini/input/input_error.h>

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <string>

BOOST_AUTO_TEST_SUITE(formula)

using namespace Signorini;

namespace
{
  const Constants constants = {{"pi", 3.141592653589793}, {"F", 1e3}};

  template <typename Action>
  std::string
  message(const Action &action)
  {
    try
      {
        action();
      }
    catch (const InputError &error)
      {
        return error.what();
      }
    return "";
  }

  std::string
  message_of(const std::string              &text,
             const std::vector<std::string> &variables = {"x", "t"})
  {
    return message([&] { Formula(text, variables, constants, "Load"); });
  }

  bool
  begins(const std::string &text, const std::string &begin)
  {
    BOOST_TEST_INFO(text);
    return text.rfind(begin, 0) == 0;
  }
} // namespace



BOOST_AUTO_TEST_CASE(values)
{
  const Formula f("F*x + sin(pi*t)", {"x", "t"}, constants, "Load");
  BOOST_TEST(std::abs(f.value({2., 0.5}) - 2001.) < 1e-9);
  BOOST_TEST(f.depends_on("x"));
  BOOST_TEST(!f.depends_on("y"));
  BOOST_TEST(Formula("1.5e-3", {}, {}, "").value({}) == 1.5e-3);
  BOOST_TEST(Formula("if(v > 1, 2, 3)", {"v"}, {}, "").value({0.5}) == 3.);
  BOOST_TEST(
    Formula("x+y+z+t", Formula::space_and_time, {}, "").value({1, 2, 3, 4}) ==
    10.);
}

BOOST_AUTO_TEST_CASE(no_number)
{
  const Formula root("sqrt(0.5 - t)", {"x", "t"}, constants, "Load");
  BOOST_TEST(root.value({0., 0.25}) == 0.5);
  BOOST_TEST(message([&] {
               root.value({2., 0.75});
             }) ==
             "Load: the expression \"sqrt(0.5 - t)\" is not a number at x = 2, "
             "t = 0.75. It needs a finite value wherever it is used.");
  BOOST_TEST(message([] { Formula("1/t", {"t"}, {}, "Load").value({0.}); }) ==
             "Load: the expression \"1/t\" is infinite at t = 0. It needs "
             "a finite value wherever it is used.");
}

BOOST_AUTO_TEST_CASE(variables_without_meaning)
{
  BOOST_TEST(message_of("-1e6*y") ==
             "Load: the expression \"-1e6*y\" depends on y, but it may depend "
             "on x, t only.");
  BOOST_TEST(message_of("t", {}) ==
             "Load: the expression \"t\" depends on t, but it may depend on no "
             "variable.");
}

BOOST_AUTO_TEST_CASE(names_that_are_not_known)
{
  BOOST_TEST(begins(message_of("-G*t"),
                    "Load: the expression \"-G*t\" has the unknown name "
                    "\"G\"."));
  BOOST_TEST(begins(message_of("expp(t)"),
                    "Load: the expression \"expp(t)\" has the unknown name "
                    "\"expp\". Did you mean \"exp\"?"));
  BOOST_TEST(begins(message_of("rand()"),
                    "Load: the expression \"rand()\" has the unknown name"));
  BOOST_TEST(begins(message_of("2*unused_3"), "Load: the expression"));
  BOOST_TEST(message_of("0x10").find("unknown name \"x10\"") !=
             std::string::npos);
}

BOOST_AUTO_TEST_CASE(no_expression)
{
  for (const std::string text : {"",
                                 " ",
                                 "(",
                                 "1 +",
                                 "sin()",
                                 "sin(1, 2)",
                                 "1 2",
                                 "x = 2",
                                 "1,5",
                                 "2*(1,5)",
                                 "1 == 1, 2",
                                 "1..2",
                                 "$",
                                 "\"a\"",
                                 "1e",
                                 ")(",
                                 "if(1",
                                 "x?1",
                                 "ä"})
    BOOST_TEST(begins(message_of(text), "Load: "), text);
}

BOOST_AUTO_TEST_CASE(deep_and_long_ones)
{
  const auto nested = [](const unsigned int depth) {
    return std::string(depth, '(') + "x" + std::string(depth, ')');
  };
  BOOST_TEST(message_of(nested(1000)) == "");
  BOOST_TEST(begins(message_of(nested(100000)),
                    "Load: the expression has 200001 characters, allowed are "
                    "10000."));
  std::string calls = "x";
  for (unsigned int i = 0; i < 1900; ++i)
    calls = "sin(" + calls + ")";
  BOOST_TEST(message_of(calls) == "");
}

BOOST_AUTO_TEST_CASE(constants_and_their_names)
{
  const Constants list = parse_constants("F = 2*pi, h_2 = 0.02", "Constants");
  BOOST_TEST(list.size() == 3u);
  BOOST_TEST(std::abs(list.at("F") - 2. * list.at("pi")) < 1e-15);
  for (const std::string text : {"a-b = 1", "a b = 1",      "a.b = 1",
                                 "a/b = 1", "1a = 1",       "= 1",
                                 "a",       "x = 1",        "t = 1",
                                 "v = 1",   "sin = 1",      "if = 1",
                                 "_pi = 3", "pi = 3",       "a = 1, a = 2",
                                 "a = 1/0", "a = sqrt(-1)", "a = b",
                                 "a = ",    "ä = 1",        "a = 1e-310"})
    BOOST_TEST(begins(message([&] { parse_constants(text, "Constants"); }),
                      "Constants: "),
               text);
}

BOOST_AUTO_TEST_SUITE_END()
