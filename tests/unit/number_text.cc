#include <signorini/input/input_error.h>
#include <signorini/input/number_text.h>

#include <boost/test/unit_test.hpp>

BOOST_AUTO_TEST_SUITE(number_text)

using namespace dealii;
using namespace Signorini;

namespace
{
  const Constants constants = {{"h", 0.1}, {"n", 3.}, {"to", 7.}};

  std::string
  evaluated(const std::string &value, const Patterns::PatternBase &pattern)
  {
    return evaluate_numbers(value,
                            pattern.description(Patterns::PatternBase::Machine),
                            constants);
  }
} // namespace



BOOST_AUTO_TEST_CASE(numbers)
{
  BOOST_TEST(evaluated("2*h", Patterns::Double()) == "0.2");
  BOOST_TEST(evaluated("3*h", Patterns::Double(0.)) == "0.30000000000000004");
  BOOST_TEST(evaluated("n/h + 1", Patterns::Integer()) == "31");
  BOOST_TEST(evaluated("-n", Patterns::Integer()) == "-3");
  // Literals stay as they are written.
  BOOST_TEST(evaluated("1.50e+03", Patterns::Double()) == "1.50e+03");
  BOOST_TEST(evaluated("2.5", Patterns::Integer()) == "2.5");
  BOOST_TEST(evaluated("", Patterns::Double()) == "");
  BOOST_CHECK_THROW(evaluated("h", Patterns::Integer()), InputError);
  BOOST_CHECK_THROW(evaluated("2*w", Patterns::Double()), InputError);
  BOOST_CHECK_THROW(evaluated("1/0", Patterns::Double()), InputError);
}

BOOST_AUTO_TEST_CASE(lists)
{
  const Patterns::List point(Patterns::Double(), 2, 2);
  const Patterns::List points(point, 2, 2, ";");
  BOOST_TEST(evaluated("0, 0 ; n, 2*h", points) == "0, 0 ; 3, 0.2");
  BOOST_TEST(evaluated("max(h, n), 1", point) == "3, 1");
  BOOST_TEST(evaluated("(h > n ? 1 : 2), h", point) == "2, 0.1");
}

BOOST_AUTO_TEST_CASE(other_entries_have_no_numbers)
{
  BOOST_TEST(evaluated("h", Patterns::Anything()) == "h");
  BOOST_TEST(evaluated("h", Patterns::Selection("h|n")) == "h");
}

BOOST_AUTO_TEST_CASE(texts)
{
  BOOST_TEST(evaluated("0: 2*n | h: 8", NumberText()) == "0: 6 | 0.1: 8");
  BOOST_TEST(evaluated("", NumberText()) == "");
  BOOST_TEST(evaluated("file h.txt", NumberText()) == "file h.txt");
  BOOST_CHECK_THROW(evaluated("to h", NumberText()), InputError);

  const NumberText outline({"arc", "left", "about", "to"});
  BOOST_TEST(evaluated("h, 0 ; arc n, to to 1, 2*h ; left about 0, h to 1, n",
                       outline) ==
             "0.1, 0 ; arc 3, to to 1, 0.2 ; left about 0, 0.1 to 1, 3");
}

BOOST_AUTO_TEST_CASE(names_are_no_constants)
{
  BOOST_TEST(evaluated("h : n ; n : 2*n : h/2 ;", NumberText::behind_names()) ==
             "h : 3 ; n : 6 : 0.05 ;");
  BOOST_TEST(evaluated("h", NumberText::behind_names()) == "h");
}

BOOST_AUTO_TEST_SUITE_END()
