#include <signorini/contact/contact_point.h>
#include <signorini/input/instantiate.h>

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



#define INSTANTIATE(dim) template struct ContactPoint<dim>;
  SIGNORINI_FOR_EACH_DIMENSION(INSTANTIATE)
#undef INSTANTIATE
} // namespace Signorini
