#ifndef signorini_simulation_platform_h
#define signorini_simulation_platform_h

#include <string>

namespace Signorini
{
  /** Program, build type, deal.II and BLAS in use, one per line. */
  std::string
  versions();

  /**
   * Let the dense algebra of OpenBLAS use at most so many threads; those of
   * deal.II are limited by MPI_InitFinalize.
   */
  void
  limit_blas_threads(const unsigned int n_threads);
} // namespace Signorini

#endif
