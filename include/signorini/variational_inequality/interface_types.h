#ifndef signorini_variational_inequality_interface_types_h
#define signorini_variational_inequality_interface_types_h

#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/vector.h>

namespace Signorini
{
  /** A value for each unknown of the interface, or for each contact. */
  using InterfaceVector = dealii::Vector<double>;

  /** What couples them, without zeros. */
  using InterfaceMatrix = dealii::FullMatrix<double>;
} // namespace Signorini

#endif
