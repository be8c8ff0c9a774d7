#include <signorini/contact/interface_numbering.h>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    constexpr unsigned int constrained      = numbers::invalid_unsigned_int;
    constexpr unsigned int not_on_interface = constrained - 1;
  } // namespace



  InterfaceNumbering::InterfaceNumbering(const DofMap &dof_map)
    : dof_map_(dof_map)
  {
    for (const bool is_constrained : dof_map.constrained())
      index_.push_back(is_constrained ? constrained : not_on_interface);
  }



  void
  InterfaceNumbering::add(const unsigned int unknown)
  {
    const auto &constraints = dof_map_.constraints();
    if (!constraints.is_constrained(unknown))
      add_free(unknown);
    else
      for (const auto &[master, factor] :
           *constraints.get_constraint_entries(unknown))
        add_free(master);
  }



  void
  InterfaceNumbering::add_free(const unsigned int unknown)
  {
    if (index_[unknown] != not_on_interface)
      return;
    index_[unknown] = unknowns_.size();
    unknowns_.push_back(unknown);
  }



  SparseRow
  InterfaceNumbering::row(const SparseRow &of_all, const double factor) const
  {
    SparseRow result;
    for (const auto &[unknown, coefficient] : of_all)
      if (index_[unknown] < unknowns_.size() && coefficient != 0.)
        result.add(index_[unknown], factor * coefficient);
    return result;
  }



  void
  InterfaceNumbering::add_curvature(const GapCurvature &curvature,
                                    const double        factor,
                                    InterfaceMatrix    &matrix) const
  {
    const auto &[unknowns, second_derivative] = curvature;
    for (unsigned int i = 0; i < unknowns.size(); ++i)
      for (unsigned int j = 0; j < unknowns.size(); ++j)
        {
          const unsigned int row    = index_[unknowns[i]];
          const unsigned int column = index_[unknowns[j]];
          if (row < unknowns_.size() && column < unknowns_.size())
            matrix(row, column) += factor * second_derivative(i, j);
        }
  }
} // namespace Signorini
