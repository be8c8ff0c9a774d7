#include <signorini/linear_algebra/cholesky_condensation.h>

namespace Signorini
{
  using namespace dealii;

  void
  CholeskyCondensation::prepare(const SparsityPattern           &pattern,
                                const std::vector<bool>         &is_fixed,
                                const std::vector<unsigned int> &interface)
  {
    cholesky_.analyse(pattern, is_fixed, interface);
    n_interface_ = interface.size();
    half_solution_.reinit(cholesky_.order().size());
  }



  void
  CholeskyCondensation::factorise(const DofMatrix &matrix)
  {
    cholesky_.factorise(matrix);
    trailing_ =
      InterfaceStiffness::from_cholesky_factor(n_interface_,
                                               cholesky_.trailing_factor());
  }



  InterfaceStiffness
  CholeskyCondensation::interface_stiffness() const
  {
    return trailing_;
  }



  InterfaceVector
  CholeskyCondensation::condense(const DofVector &residual)
  {
    const auto &order = cholesky_.order();
    for (unsigned int i = 0; i < order.size(); ++i)
      half_solution_[i] = residual[order[i]];
    cholesky_.forward_substitution(half_solution_);

    return InterfaceVector(half_solution_.end() - n_interface_,
                           half_solution_.end());
  }



  void
  CholeskyCondensation::expand(const InterfaceVector &interface_displacement,
                               DofVector             &displacement)
  {
    InterfaceVector trailing(interface_displacement);
    trailing_.multiply_transposed_factor(trailing);
    std::copy(trailing.begin(),
              trailing.end(),
              half_solution_.end() - n_interface_);
    cholesky_.backward_substitution(half_solution_);

    const auto &order = cholesky_.order();
    displacement      = 0.;
    for (unsigned int i = 0; i < order.size(); ++i)
      displacement[order[i]] = half_solution_[i];
  }
} // namespace Signorini
