#include <signorini/variational_inequality/compliance_matrix.h>

#include <algorithm>
#include <map>

namespace Signorini
{
  using namespace dealii;

  void
  ComplianceMatrix::clear()
  {
    rows.clear();
    W.reinit(0, 0);
    kept_factor.clear();
  }



  void
  ComplianceMatrix::set_rows(const std::vector<unsigned int> &row_numbers,
                             const Entry                     &entry)
  {
    constexpr unsigned int unknown = numbers::invalid_unsigned_int;
    std::map<unsigned int, unsigned int> position;
    for (unsigned int i = 0; i < rows.size(); ++i)
      position[rows[i]] = i;
    const unsigned int        n = row_numbers.size();
    std::vector<unsigned int> old(n, unknown);
    for (unsigned int i = 0; i < n; ++i)
      {
        const auto found = position.find(row_numbers[i]);
        if (found != position.end())
          old[i] = found->second;
      }

    InterfaceMatrix matrix(n, n);
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int j = 0; j <= i; ++j)
        matrix(i, j) = matrix(j, i) =
          old[i] != unknown && old[j] != unknown ?
            W(old[i], old[j]) :
            entry(std::max(row_numbers[i], row_numbers[j]),
                  std::min(row_numbers[i], row_numbers[j]));
    W    = std::move(matrix);
    rows = row_numbers;
    kept_factor.clear();
  }
} // namespace Signorini
