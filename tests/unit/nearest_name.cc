#include <signorini/input/nearest_name.h>

#include <boost/test/unit_test.hpp>

BOOST_AUTO_TEST_SUITE(nearest_name)

using Signorini::did_you_mean;

BOOST_AUTO_TEST_CASE(misspelt_names)
{
  const std::vector<std::string> names   = {"left", "right", "bottom", "top"};
  const auto                     nearest = [&](const std::string &name) {
    return Signorini::nearest_name(name, names);
  };
  BOOST_TEST(nearest("botom") == "bottom");  // a letter too few
  BOOST_TEST(nearest("lefft") == "left");    // one too many
  BOOST_TEST(nearest("righr") == "right");   // a wrong one
  BOOST_TEST(nearest("rihgt") == "right");   // two exchanged
  BOOST_TEST(nearest("Bottom") == "bottom"); // other case
  BOOST_TEST(nearest("bottom") == "bottom"); // itself
  BOOST_TEST(nearest("underside") == "");
  BOOST_TEST(nearest("") == "");
  BOOST_TEST(Signorini::nearest_name("x", {"y"}) == "");
  BOOST_TEST(Signorini::nearest_name("x", {}) == "");
}

BOOST_AUTO_TEST_CASE(a_third_may_differ)
{
  // Nine letters: three differences are allowed, four are not.
  BOOST_TEST(Signorini::nearest_name("abcdefghi", {"abcdefxyz"}) ==
             "abcdefxyz");
  BOOST_TEST(Signorini::nearest_name("abcdefghi", {"abcdewxyz"}) == "");
  // The nearer one wins; the first one if they are equally near.
  BOOST_TEST(Signorini::nearest_name("abcde", {"abcxy", "abcdx"}) == "abcdx");
  BOOST_TEST(Signorini::nearest_name("abcde", {"abcdx", "abcdy"}) == "abcdx");
}

BOOST_AUTO_TEST_CASE(sentences)
{
  BOOST_TEST(did_you_mean("rimm", {"flat", "rim"}) == " Did you mean \"rim\"?");
  BOOST_TEST(did_you_mean("anything", {"flat", "rim"}) == "");
  BOOST_TEST(Signorini::comma_separated({"a", "b"}) == "a, b");
  BOOST_TEST(Signorini::comma_separated({}) == "none");
}

BOOST_AUTO_TEST_SUITE_END()
