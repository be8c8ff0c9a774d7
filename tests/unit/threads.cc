#include <signorini/linear_algebra/sparse_cholesky.h>
#include <signorini/run/threads.h>

#include <deal.II/base/parallel.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/lapack_full_matrix.h>

#include <boost/test/unit_test.hpp>

#include <chrono>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <thread>

BOOST_AUTO_TEST_SUITE(threads)

using namespace Signorini;
using namespace dealii;

namespace
{
  // What each thread of the process has computed so far, ns (proc(5)).
  std::map<std::string, double>
  computing_times()
  {
    std::map<std::string, double> times;
    for (const auto &task :
         std::filesystem::directory_iterator("/proc/self/task"))
      std::ifstream(task.path() / "schedstat") >> times[task.path()];
    return times;
  }

  // Threads that have nothing to do look out for work some time before they
  // sleep. Waits until nobody computed for a while, but who waits.
  void
  wait_for_sleep()
  {
    constexpr double negligible = 1e6; // ns
    for (unsigned int trial = 0; trial < 100; ++trial)
      {
        const auto before = computing_times();
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
        double sum = 0.;
        for (const auto &[task, time] : computing_times())
          if (const auto old = before.find(task); old != before.end())
            sum += time - old->second;
        if (sum < negligible)
          return;
      }
  }

  struct Threads
  {
    unsigned int n_sharing;   // with a share in what the work takes
    unsigned int n_at_a_time; // computing time over time
  };

  // Those that sleep, or look up now and then, as MPI's do, have no share. A
  // pool may give the work now to one and now to another of its threads.
  template <typename Work>
  Threads
  threads_of(const Work &work)
  {
    constexpr double least_share = 0.05;
    wait_for_sleep();
    const auto before = computing_times();
    const auto start  = std::chrono::steady_clock::now();
    work();
    const std::chrono::duration<double, std::nano> elapsed =
      std::chrono::steady_clock::now() - start;
    auto   after = computing_times();
    double total = 0.;
    for (auto &[task, time] : after)
      {
        if (const auto old = before.find(task); old != before.end())
          time -= old->second;
        total += time;
      }
    BOOST_TEST(total > 0.);
    const unsigned int n_sharing =
      std::count_if(after.begin(), after.end(), [&](const auto &task) {
        return task.second > least_share * total;
      });
    return {n_sharing,
            unsigned(std::ceil(total / elapsed.count() - 2. * least_share))};
  }

  // Of some repetitions: on a busy machine a thread may come late from what was
  // before, or not get its turn.
  template <typename Work>
  bool
  takes_threads(const unsigned int n_threads, const Work &work)
  {
    Threads found = threads_of(work);
    for (unsigned int repetition = 0; repetition < 3; ++repetition)
      {
        const Threads next = threads_of(work);
        found.n_sharing    = std::max(found.n_sharing, next.n_sharing);
        found.n_at_a_time  = std::min(found.n_at_a_time, next.n_at_a_time);
      }
    return found.n_sharing >= n_threads && found.n_at_a_time <= n_threads;
  }

  template <typename Work>
  unsigned int
  n_working_threads(const Work &work)
  {
    unsigned int least = threads_of(work).n_at_a_time;
    for (unsigned int repetition = 0; repetition < 3; ++repetition)
      least = std::min(least, threads_of(work).n_at_a_time);
    return least;
  }

  // The Laplacian on a grid of n^3 points: wide supernodes, for which CHOLMOD
  // asks OpenMP for threads.
  class Grid
  {
  public:
    explicit Grid(const unsigned int n)
    {
      const unsigned int     size = n * n * n;
      DynamicSparsityPattern dynamic(size);
      const auto             for_neighbours = [&](const auto &visit) {
        for (unsigned int i = 0; i < size; ++i)
          for (const unsigned int stride : {1u, n, n * n})
            if (i / stride % n + 1 < n)
              visit(i, i + stride);
      };
      for (unsigned int i = 0; i < size; ++i)
        dynamic.add(i, i);
      for_neighbours([&](const unsigned int i, const unsigned int j) {
        dynamic.add(i, j);
        dynamic.add(j, i);
      });
      pattern.copy_from(dynamic);
      matrix.reinit(pattern);
      for (unsigned int i = 0; i < size; ++i)
        matrix.set(i, i, 6.1);
      for_neighbours([&](const unsigned int i, const unsigned int j) {
        matrix.set(i, j, -1.);
        matrix.set(j, i, -1.);
      });
      cholesky.analyse(pattern, std::vector<bool>(size), {});
    }

    void
    factorise()
    {
      cholesky.factorise(matrix);
    }

  private:
    SparsityPattern      pattern;
    SparseMatrix<double> matrix;
    SparseCholesky       cholesky;
  };

  // OpenBLAS.
  void
  multiply_dense()
  {
    const unsigned int       n = 600;
    LAPACKFullMatrix<double> a(n, n), product(n, n);
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int j = 0; j < n; ++j)
        a(i, j) = i == j ? 2. : 1.;
    for (unsigned int repetition = 0; repetition < 8; ++repetition)
      a.mmult(product, a);
    BOOST_TEST(product(n - 1, 0) == n + 2.);
  }

  // TBB.
  void
  sum_in_ranges()
  {
    const double sum = parallel::accumulate_from_subranges<double>(
      [](const std::size_t begin, const std::size_t end) {
        double part = 0.;
        for (std::size_t i = begin; i < end; ++i)
          part += std::sin(i) * std::sin(i) + std::cos(i) * std::cos(i);
        return part;
      },
      std::size_t(0),
      std::size_t(1000000),
      1000);
    BOOST_TEST(sum == 1e6, boost::test_tools::tolerance(1e-9));
  }
} // namespace



// No library takes more threads than it was given.
BOOST_AUTO_TEST_CASE(are_as_many_as_asked_for)
{
  Grid grid(20);
  for (const unsigned int n_threads : {2u, 1u})
    {
      limit_threads(n_threads);
      BOOST_TEST_CONTEXT(n_threads << " threads")
      {
        BOOST_TEST(takes_threads(n_threads, multiply_dense));
        BOOST_TEST(n_working_threads(sum_in_ranges) <= n_threads);
        BOOST_TEST(n_working_threads([&] {
                     for (unsigned int i = 0; i < 10; ++i)
                       grid.factorise();
                   }) <= n_threads);
      }
    }
}



// A small factor has one thread, whatever is allowed.
BOOST_AUTO_TEST_CASE(of_small_models_are_one_in_the_dense_algebra)
{
  limit_threads(2);
  choose_blas_threads(100);
  BOOST_TEST(takes_threads(1, multiply_dense));
  choose_blas_threads(100000);
  BOOST_TEST(takes_threads(2, multiply_dense));
  limit_threads(1);
}

BOOST_AUTO_TEST_SUITE_END()
