#include <signorini/output/timings.h>

#include <boost/test/unit_test.hpp>

#include <chrono>
#include <thread>

BOOST_AUTO_TEST_SUITE(timings)

using Signorini::Timings;

namespace
{
  void
  sleep(const int milliseconds)
  {
    std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds));
  }
} // namespace



// Sleeping takes at least its time; on a busy machine longer. So bounds are
// from below, and from above by the total.
BOOST_AUTO_TEST_CASE(nested_scopes_are_counted_once)
{
  Timings            timings;
  const unsigned int outer = timings.add("outer");
  {
    const auto timing = timings.measure(outer);
    sleep(4);
    for (unsigned int i = 0; i < 2; ++i)
      {
        const auto inner = timings.measure("inner");
        sleep(6);
      }
    sleep(2);
  }
  sleep(3);

  const double before = timings.total_seconds();
  const double sum    = timings.seconds("outer") + timings.seconds("inner") +
                     timings.seconds("other");
  const double after = timings.total_seconds();
  BOOST_TEST(timings.seconds("outer") >= 6e-3);
  BOOST_TEST(timings.seconds("inner") >= 12e-3);
  BOOST_TEST(timings.seconds("other") >= 3e-3);
  BOOST_TEST(before <= sum + 1e-9);
  BOOST_TEST(sum <= after + 1e-9);
  BOOST_TEST(timings.n_calls("outer") == 1u);
  BOOST_TEST(timings.n_calls("inner") == 2u);
}

BOOST_AUTO_TEST_CASE(a_running_section_is_read_up_to_now)
{
  Timings    timings;
  const auto timing = timings.measure("a");
  sleep(3);
  BOOST_TEST(timings.seconds("a") >= 3e-3);
}

BOOST_AUTO_TEST_CASE(names_and_indices_are_the_same_sections)
{
  Timings timings;
  BOOST_TEST(timings.add("a") != timings.add("b"));
  BOOST_TEST(timings.add("a") == timings.add("a"));
  {
    const auto by_index = timings.measure(timings.add("b"));
  }
  {
    const auto by_name = timings.measure("b");
  }
  BOOST_TEST(timings.n_calls("b") == 2u);
  BOOST_TEST(timings.n_calls("a") == 0u);
  BOOST_TEST(timings.n_calls("unknown") == 0u);
  BOOST_TEST(timings.seconds("unknown") == 0.);
}

BOOST_AUTO_TEST_CASE(the_table_has_what_ran)
{
  Timings timings;
  timings.add("never entered");
  {
    const auto timing = timings.measure("assembly");
  }
  const std::string table = timings.table();
  BOOST_TEST(table.find("assembly") == 0u);
  BOOST_TEST(table.find(" 1 call\n") != std::string::npos);
  BOOST_TEST(table.find("never entered") == std::string::npos);
  BOOST_TEST(table.find("\nother ") != std::string::npos);
  BOOST_TEST(table.find("\ntotal ") != std::string::npos);
  BOOST_TEST(table.find("100.0 %\n") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(cost_of_a_scope)
{
  Timings                timings;
  const unsigned int     section = timings.add("scope");
  constexpr unsigned int n       = 100000;
  for (unsigned int i = 0; i < n; ++i)
    const auto timing = timings.measure(section);
  BOOST_TEST(timings.n_calls("scope") == n);
  BOOST_TEST_MESSAGE("A scope costs " << 1e9 * timings.total_seconds() / n
                                      << " ns.");
}

BOOST_AUTO_TEST_SUITE_END()
