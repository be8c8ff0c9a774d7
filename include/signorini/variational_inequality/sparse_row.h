#ifndef signorini_variational_inequality_sparse_row_h
#define signorini_variational_inequality_sparse_row_h


#include <signorini/variational_inequality/interface_types.h>

#include <cmath>
#include <initializer_list>
#include <utility>
#include <vector>

namespace Signorini
{
  /**
   * A row of a constraint matrix on the interface: (DoF, coefficient) for its
   * few nonzero entries, the DoFs counted from 0 to n - 1 on the interface.
   * Entries of the same DoF add up.
   */
  class SparseRow
  {
  public:
    using Entry = std::pair<unsigned int, double>;

    SparseRow() = default;

    SparseRow(const std::initializer_list<Entry> entries)
      : entries(entries)
    {}

    void
    add(const unsigned int dof, const double coefficient)
    {
      entries.emplace_back(dof, coefficient);
    }

    /** sum_i a_i x_i. */
    double
    dot(const InterfaceVector &x) const
    {
      double sum = 0.;
      for (const auto &[dof, coefficient] : entries)
        sum += coefficient * x(dof);
      return sum;
    }

    /** sum_i |a_i x_i|: the scale of the rounding error of dot(). */
    double
    absolute_dot(const InterfaceVector &x) const
    {
      double sum = 0.;
      for (const auto &[dof, coefficient] : entries)
        sum += std::abs(coefficient * x(dof));
      return sum;
    }

    /** x <- x + factor a. */
    void
    add_to(InterfaceVector &x, const double factor) const
    {
      for (const auto &[dof, coefficient] : entries)
        x(dof) += factor * coefficient;
    }

    std::size_t
    size() const
    {
      return entries.size();
    }

    std::vector<Entry>::const_iterator
    begin() const
    {
      return entries.begin();
    }

    std::vector<Entry>::const_iterator
    end() const
    {
      return entries.end();
    }

    bool
    operator==(const SparseRow &other) const
    {
      return entries == other.entries;
    }

    bool
    operator!=(const SparseRow &other) const
    {
      return entries != other.entries;
    }

  private:
    std::vector<Entry> entries;
  };
} // namespace Signorini

#endif
