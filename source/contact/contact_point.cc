#include <signorini/contact/contact_point.h>

#include <map>

namespace Signorini
{
  namespace
  {
    SparseRow
    merged(const SparseRow &row)
    {
      std::map<unsigned int, double> sums;
      for (const auto &[unknown, coefficient] : row)
        sums[unknown] += coefficient;
      SparseRow result;
      for (const auto &[unknown, sum] : sums)
        result.add(unknown, sum);
      return result;
    }
  } // namespace



  template <int dim>
  void
  ContactPoint<dim>::merge_rows()
  {
    gap_gradient = merged(gap_gradient);
    for (SparseRow &row : slip_gradients)
      row = merged(row);
  }



  template struct ContactPoint<2>;
  template struct ContactPoint<3>;
} // namespace Signorini
