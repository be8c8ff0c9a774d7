#include <signorini/input/pattern_in_words.h>

#include <deal.II/base/patterns.h>

#include <boost/test/unit_test.hpp>

BOOST_AUTO_TEST_SUITE(pattern_in_words)

// The descriptions come from deal.II's own patterns, so that a change of its
// wording is noticed.
namespace
{
  using namespace dealii::Patterns;

  std::string
  in_words(const PatternBase &pattern)
  {
    return Signorini::pattern_in_words(pattern.description());
  }
} // namespace



BOOST_AUTO_TEST_CASE(numbers)
{
  BOOST_TEST(in_words(Double()) == "a number");
  BOOST_TEST(in_words(Double(0.)) == "a number >= 0");
  BOOST_TEST(in_words(Double(Double::min_double_value, 2.5)) ==
             "a number <= 2.5");
  BOOST_TEST(in_words(Double(-1e-9, 0.5)) == "a number from -1e-09 to 0.5");
  BOOST_TEST(in_words(Integer()) == "a whole number");
  BOOST_TEST(in_words(Integer(1)) == "a whole number >= 1");
  BOOST_TEST(in_words(Integer(Integer::min_int_value, -2)) ==
             "a whole number <= -2");
  BOOST_TEST(in_words(Integer(-1, 3)) == "a whole number from -1 to 3");
}

BOOST_AUTO_TEST_CASE(texts)
{
  BOOST_TEST(in_words(Anything()) == "any text");
  BOOST_TEST(in_words(Bool()) == "true or false");
  BOOST_TEST(in_words(FileName()) == "the name of a file");
  BOOST_TEST(in_words(DirectoryName()) == "the name of a folder");
  BOOST_TEST(in_words(Selection("plane strain|plane stress")) ==
             "one of plane strain, plane stress");
  BOOST_TEST(in_words(MultipleSelection("x|y")) ==
             "a list, separated by \",\", of: x, y");
}

BOOST_AUTO_TEST_CASE(lists)
{
  BOOST_TEST(in_words(List(Double(0.))) ==
             "a list, separated by \",\", of: a number >= 0");
  BOOST_TEST(in_words(List(Anything(), 2, 3, "|")) ==
             "a list, separated by \"|\", 2 to 3 of them, of: any text");
  BOOST_TEST(
    in_words(List(List(Integer(), 2, 2), 1, List::max_int_value, ";")) ==
    "a list, separated by \";\", at least 1, of: a list, separated "
    "by \",\", 2 of them, of: a whole number");
  const Map map{Anything(), Double()};
  BOOST_TEST(in_words(map) == map.description());
}

BOOST_AUTO_TEST_CASE(names)
{
  using Names      = std::vector<std::string>;
  const auto names = [](const PatternBase &pattern) {
    return Signorini::names_in_pattern(pattern.description());
  };
  BOOST_TEST((names(Selection("a b|c")) == Names{"a b", "c"}));
  BOOST_TEST((names(MultipleSelection("a b|c")) == Names{"a b", "c"}));
  BOOST_TEST((names(List(Selection("a|b"))) == Names{"a", "b"}));
  BOOST_TEST(names(Double()).empty());
}

BOOST_AUTO_TEST_SUITE_END()
