#ifndef signorini_linear_algebra_types_h
#define signorini_linear_algebra_types_h

#include <deal.II/lac/sparse_matrix.h>
#include <deal.II/lac/vector.h>

namespace Signorini
{
  /** A value for each unknown of a problem: displacements, forces. */
  using DofVector = dealii::Vector<double>;

  /** What couples the unknowns of a problem: stiffness, mass, damping. */
  using DofMatrix = dealii::SparseMatrix<double>;
} // namespace Signorini

#endif
