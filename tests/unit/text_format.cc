#include <signorini/input/text_format.h>

#include <boost/test/unit_test.hpp>

BOOST_AUTO_TEST_SUITE(text_format)

using Signorini::html;
using Signorini::markdown;
using Signorini::TextFormat;

BOOST_AUTO_TEST_CASE(characters_of_the_language)
{
  BOOST_TEST(markdown()->text("a_b | c < d") == "a\\_b \\| c &lt; d");
  BOOST_TEST(html()->text("a_b & \"c\" < d") ==
             "a_b &amp; &quot;c&quot; &lt; d");
}

BOOST_AUTO_TEST_CASE(code_within_text)
{
  BOOST_TEST(markdown()->text("as `a | b_c' or Young's") ==
             "as `a \\| b_c` or Young's");
  BOOST_TEST(html()->text("as `a < b'.") == "as <code>a &lt; b</code>.");
  BOOST_TEST(markdown()->text("no `end") == "no `end");
  BOOST_TEST(markdown()->code("") == "");
}

BOOST_AUTO_TEST_CASE(anchors)
{
  BOOST_TEST(TextFormat::anchor("Body NAME / Young's modulus") ==
             "body-name--youngs-modulus");
  BOOST_TEST(html()->heading(2, "Body NAME / Loads") ==
             "<h2 id=\"body-name--loads\">Body NAME / Loads</h2>\n");
}

BOOST_AUTO_TEST_CASE(tables)
{
  BOOST_TEST(markdown()->table({{"a", "b"}, {"1", ""}}) ==
             "\n| a | b |\n| --- | --- |\n| 1 |  |\n");
  BOOST_TEST(html()->table({{"a"}, {"1"}}) ==
             "<table>\n<tr><th>a</th></tr>\n<tr><td>1</td></tr>\n</table>\n");
}

BOOST_AUTO_TEST_SUITE_END()
