#ifndef signorini_geometry_memory_estimate_h
#define signorini_geometry_memory_estimate_h

namespace Signorini
{
  /**
   * Memory of a run on a mesh of bilinear or trilinear cells, in bytes: the
   * mesh and the matrices in proportion to the number N of cells, and the
   * factor of the stiffness, with nested dissection in 2-D about 30 N log2 N
   * numbers and in 3-D about 45 N^(4/3) [George1973].
   */
  double
  estimated_memory(const double n_cells, const unsigned int dim);

  /** Memory of this machine, in bytes. */
  double
  physical_memory();

  /**
   * Refuses a mesh for which the estimate is more than twice the memory of this
   * machine.
   * @throws InputError with both
   */
  void
  require_memory(const double n_cells, const unsigned int dim);
} // namespace Signorini

#endif
