#include <signorini/input/as_text.h>
#include <signorini/input/input_error.h>
#include <signorini/output/history_writer.h>
#include <signorini/output/run_folder.h>

#include <boost/archive/text_iarchive.hpp>
#include <boost/archive/text_oarchive.hpp>
#include <boost/test/unit_test.hpp>

#include <sys/resource.h>

#include <csignal>
#include <limits>

#include "temporary_folder.h"

BOOST_AUTO_TEST_SUITE(history_writer)

using namespace Signorini;

namespace
{
  History
  example()
  {
    History history;
    history.add_column("floor.force_y", "N");
    history.add_column("floor.contacts", "");
    return history;
  }

  /** The disk is full after this many bytes of a file. */
  class SmallDisk
  {
  public:
    explicit SmallDisk(const rlim_t n_bytes)
      : old_handler(std::signal(SIGXFSZ, SIG_IGN))
    {
      getrlimit(RLIMIT_FSIZE, &old_limit);
      rlimit limit   = old_limit;
      limit.rlim_cur = n_bytes;
      setrlimit(RLIMIT_FSIZE, &limit);
    }

    ~SmallDisk()
    {
      setrlimit(RLIMIT_FSIZE, &old_limit);
      std::signal(SIGXFSZ, old_handler);
    }

  private:
    void (*old_handler)(int);
    rlimit old_limit;
  };
} // namespace



BOOST_AUTO_TEST_CASE(columns_and_rows)
{
  History history = example();
  history.append_row({0., 1., 2.});
  history.append_row({0.5, 3., 4.});
  BOOST_TEST(history.n_rows() == 2u);
  BOOST_TEST(history.column_index("floor.contacts") == 2u);
  BOOST_TEST(history.value(1, 1) == 3.);
  BOOST_TEST(history.values("floor.contacts") == (std::vector<double>{2., 4.}));
  BOOST_TEST(history.times() == (std::vector<double>{0., 0.5}));

  const History copy = history;
  history.truncate(1);
  BOOST_TEST(history.times() == std::vector<double>{0.});
  history.append_row({0.25, 5., 6.});
  BOOST_TEST(history.values("floor.force_y") == (std::vector<double>{1., 5.}));
  BOOST_TEST(copy.values("floor.force_y") == (std::vector<double>{1., 3.}));
}

BOOST_AUTO_TEST_CASE(an_unknown_column_lists_the_known_ones)
{
  const auto is_clear = [](const InputError &error) {
    const std::string text = error.what();
    return text.find("'floor.force_x'") != std::string::npos &&
           text.find("Did you mean 'floor.force_y'?") != std::string::npos &&
           text.find("time, floor.force_y, floor.contacts") !=
             std::string::npos;
  };
  BOOST_CHECK_EXCEPTION(example().values("floor.force_x"),
                        InputError,
                        is_clear);
}

BOOST_AUTO_TEST_CASE(checkpoint)
{
  History history = example();
  history.append_row({0.1, 1. / 3., 2.});
  std::stringstream stream;
  boost::archive::text_oarchive(stream) << const_cast<const History &>(history);
  History restored = example();
  boost::archive::text_iarchive(stream) >> restored;
  BOOST_TEST(restored.n_rows() == 1u);
  BOOST_TEST(restored.value(0, 1) == 1. / 3.);
}

BOOST_AUTO_TEST_CASE(the_file_is_exact_and_complete_after_every_row)
{
  const TemporaryFolder folder;
  const std::string     name    = folder.file("history.csv");
  History               history = example();
  HistoryWriter         writer(name, history, 0.);
  const std::string     head = "time [s],floor.force_y [N],floor.contacts\n";
  BOOST_TEST(read_file(name) == head);

  history.append_row({0.1, 1. / 3., 2.});
  writer.write_new_rows(history);
  BOOST_TEST(read_file(name) == head + "0.1,0.3333333333333333,2\n");
  history.append_row({0.2, -5e-300, 0.});
  history.append_row({0.3, std::numeric_limits<double>::quiet_NaN(), 0.});
  writer.write_new_rows(history);
  BOOST_TEST(read_file(name) ==
             head + "0.1,0.3333333333333333,2\n0.2,-5e-300,0\n0.3,nan,0\n");
}

BOOST_AUTO_TEST_CASE(numbers_read_back_the_same)
{
  for (const double value : {1. / 3.,
                             0.1 + 0.2,
                             std::numeric_limits<double>::max(),
                             std::numeric_limits<double>::denorm_min(),
                             5.9539e-4})
    BOOST_TEST(std::strtod(shortest_exact(value).c_str(), nullptr) == value);
}

BOOST_AUTO_TEST_CASE(rows_are_held_back_and_written_at_the_end)
{
  const TemporaryFolder folder;
  const std::string     name    = folder.file("history.csv");
  History               history = example();
  {
    HistoryWriter writer(name, history, 1e6);
    history.append_row({0.1, 1., 2.});
    writer.write_new_rows(history);
    BOOST_TEST(read_file(name).find("0.1") == std::string::npos);
    writer.flush();
    BOOST_TEST(read_file(name).find("\n0.1,1,2\n") != std::string::npos);
    history.append_row({0.2, 3., 4.});
    writer.write_new_rows(history);
  }
  BOOST_TEST(read_file(name).find("\n0.1,1,2\n0.2,3,4\n") != std::string::npos);
}

// A run that is resumed: rows after the checkpoint go, new ones follow.
BOOST_AUTO_TEST_CASE(rows_of_an_earlier_run)
{
  const TemporaryFolder folder;
  const std::string     name = folder.file("history.csv");
  const std::string     head = "time [s],floor.force_y [N],floor.contacts\n";
  write_file(result_file(name), head + "1,1,1\n2,2,2\n3,3,");
  History history = example();
  history.append_row({1., 1., 1.});
  HistoryWriter writer(name, history, 0.);
  BOOST_TEST(read_file(name) == head + "1,1,1\n");
  history.append_row({4., 4., 4.});
  writer.write_new_rows(history);
  BOOST_TEST(read_file(name) == head + "1,1,1\n4,4,4\n");
  BOOST_TEST(!std::filesystem::exists(name + ".new"));
}

// The old rows stay, should there be no room for the same ones.
BOOST_AUTO_TEST_CASE(a_full_disk_when_a_run_is_resumed)
{
  const TemporaryFolder folder;
  const std::string     name = folder.file("history.csv");
  write_file(result_file(name), "old");
  History history = example();
  history.append_row({1., 1., 1.});
  {
    const SmallDisk disk(10);
    BOOST_CHECK_THROW(HistoryWriter(name, history), ComputationError);
  }
  BOOST_TEST(read_file(name) == "old");
}

BOOST_AUTO_TEST_CASE(a_full_disk_from_the_start)
{
  BOOST_CHECK_THROW(HistoryWriter("/dev/full", example()), ComputationError);
  BOOST_CHECK_THROW(HistoryWriter("/nowhere/history.csv", example()),
                    InputError);
}

BOOST_AUTO_TEST_CASE(a_disk_that_fills_up_keeps_whole_rows)
{
  const TemporaryFolder folder;
  const std::string     name    = folder.file("history.csv");
  History               history = example();
  const std::string     head    = "time [s],floor.force_y [N],floor.contacts\n";
  HistoryWriter         writer(name, history, 1e6);
  history.append_row({1., 1., 1.});
  writer.write_new_rows(history);
  writer.flush();
  for (const double time : {2., 3., 4.})
    history.append_row({time, time, time});
  writer.write_new_rows(history);
  {
    // Each row has 6 bytes: there is room for two and a half.
    const SmallDisk disk(head.size() + 15);
    BOOST_CHECK_EXCEPTION(writer.flush(),
                          ComputationError,
                          [&](const ComputationError &error) {
                            const std::string text = error.what();
                            return text.find(name) != std::string::npos &&
                                   text.find("File too large") !=
                                     std::string::npos;
                          });
  }
  BOOST_TEST(read_file(name) == head + "1,1,1\n2,2,2\n");
}

BOOST_AUTO_TEST_SUITE_END()
