#ifndef signorini_solid_condensed_diagonal_h
#define signorini_solid_condensed_diagonal_h

#include <signorini/linear_algebra/types.h>

#include <deal.II/lac/affine_constraints.h>

namespace Signorini
{
  /** deal.II leaves a number on the diagonal of condensed unknowns. They are
   * never solved for, and the number would count in U.K U. */
  inline void
  clear_condensed_diagonal(const dealii::AffineConstraints<double> &constraints,
                           DofMatrix                               &matrix)
  {
    for (const auto &line : constraints.get_lines())
      matrix.set(line.index, line.index, 0.);
  }
} // namespace Signorini

#endif
