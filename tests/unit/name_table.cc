#include <signorini/input/name_table.h>

#include <boost/test/unit_test.hpp>

#include <optional>

BOOST_AUTO_TEST_SUITE(name_table)

using namespace Signorini;

BOOST_AUTO_TEST_CASE(names_and_what_they_stand_for)
{
  const NameTable<std::optional<int>> table = {{"automatic", std::nullopt},
                                               {"one", 1},
                                               {"minus two", -2}};
  BOOST_TEST(table.names() == "automatic|one|minus two");
  BOOST_TEST(!table.at("automatic").has_value());
  BOOST_TEST(*table.at("minus two") == -2);
  BOOST_CHECK_THROW(table.at("two"), dealii::ExceptionBase);
}

BOOST_AUTO_TEST_SUITE_END()
