#include <signorini/run/threads.h>

#include <deal.II/base/multithread_info.h>

extern "C"
{
  void
  openblas_set_num_threads(int n_threads);

  void
  omp_set_max_active_levels(int n_levels);
}

namespace Signorini
{
  using dealii::MultithreadInfo;

  void
  limit_threads(const unsigned int n_threads)
  {
    MultithreadInfo::set_thread_limit(n_threads);
    openblas_set_num_threads(static_cast<int>(n_threads));
    // Without an active level every parallel region has one thread, also one
    // that asks for more, as omp_set_num_threads would not have it.
    omp_set_max_active_levels(0);
  }



  void
  choose_blas_threads(const unsigned int n_dofs)
  {
    constexpr unsigned int smallest_worth_threads = 20000;
    openblas_set_num_threads(n_dofs < smallest_worth_threads ?
                               1 :
                               static_cast<int>(MultithreadInfo::n_threads()));
  }
} // namespace Signorini
