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



  StiffnessBlock
  InterfaceNumbering::block(const GapCurvature &curvature,
                            const double        factor) const
  {
    // 1. What is on the interface
    std::vector<unsigned int> kept;
    StiffnessBlock            result;
    for (unsigned int i = 0; i < curvature.unknowns.size(); ++i)
      if (index_[curvature.unknowns[i]] < unknowns_.size())
        {
          kept.push_back(i);
          result.unknowns.push_back(index_[curvature.unknowns[i]]);
        }

    // 2. Its part of the second derivative
    result.matrix.reinit(kept.size(), kept.size());
    for (unsigned int i = 0; i < kept.size(); ++i)
      for (unsigned int j = 0; j < kept.size(); ++j)
        result.matrix(i, j) = factor * curvature.matrix(kept[i], kept[j]);
    return result;
  }



  void
  StiffnessBlock::add_to(InterfaceMatrix &stiffness) const
  {
    for (unsigned int i = 0; i < unknowns.size(); ++i)
      for (unsigned int j = 0; j < unknowns.size(); ++j)
        stiffness(unknowns[i], unknowns[j]) += matrix(i, j);
  }
} // namespace Signorini
