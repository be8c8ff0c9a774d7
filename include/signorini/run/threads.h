#ifndef signorini_run_threads_h
#define signorini_run_threads_h

namespace Signorini
{
  /**
   * Let the program use at most so many threads: those of deal.II (TBB) and of
   * OpenBLAS. OpenMP, which CHOLMOD would ask for four threads whatever it is
   * told, gets one; the dense blocks, where the work is, go to OpenBLAS. Has to
   * be called by the thread that will factorise, before it does.
   *
   * @param n_threads at least 1
   */
  void
  limit_threads(const unsigned int n_threads);

  /**
   * How many threads of those allowed OpenBLAS uses, so that a model of this
   * size is factorised fastest. The blocks of a small factor are so small that
   * threads only wait for each other: measured, the beam of 1 458 unknowns was
   * factorised 20 times slower with two threads than with one.
   */
  void
  choose_blas_threads(const unsigned int n_dofs);
} // namespace Signorini

#endif
