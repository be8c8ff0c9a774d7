#include <signorini/dynamics/free_modes.h>

#include <deal.II/lac/lapack_full_matrix.h>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    // Of the stiffness of the bodies: soft, so that contact decides, and far
    // above rounding.
    constexpr double softness = 1e-6;

    // Of the same: what holds less than this does not hold.
    constexpr double weakest = 1e-11;

    SparseRow
    as_row(const InterfaceVector &values)
    {
      SparseRow row;
      for (unsigned int i = 0; i < values.size(); ++i)
        if (values(i) != 0.)
          row.add(i, values(i));
      return row;
    }
  } // namespace



  FreeModes::FreeModes(const std::vector<InterfaceVector> &modes,
                       const std::vector<double>          &stiffnesses)
    : modes_(modes)
  {
    AssertDimension(modes.size(), stiffnesses.size());
    const unsigned int n = modes.size();
    for (unsigned int i = 0; i < n; ++i)
      modes_[i] /= std::sqrt(softness * stiffnesses[i]);
    FullMatrix<double> gram(n, n);
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int j = 0; j < n; ++j)
        gram(i, j) = modes_[i] * modes_[j];
    if (n > 0)
      gram.gauss_jordan();
    for (unsigned int i = 0; i < n; ++i)
      {
        duals_.emplace_back(modes_[i].size());
        for (unsigned int j = 0; j < n; ++j)
          duals_[i].add(gram(i, j), modes_[j]);
      }
  }



  std::vector<unsigned int>
  FreeModes::pins(std::vector<DofVector> modes, const DofMap &dof_map)
  {
    for (auto &mode : modes)
      for (unsigned int u = 0; u < mode.size(); ++u)
        if (dof_map.is_constrained(u))
          mode[u] = 0.;
    std::vector<unsigned int> pins;
    for (unsigned int k = 0; k < modes.size(); ++k)
      {
        // 1. The largest pivot left
        unsigned int mode = k, pin = 0;
        for (unsigned int i = k; i < modes.size(); ++i)
          for (unsigned int u = 0; u < modes[i].size(); ++u)
            if (std::abs(modes[i][u]) > std::abs(modes[mode][pin]))
              {
                mode = i;
                pin  = u;
              }
        std::swap(modes[k], modes[mode]);
        pins.push_back(pin);
        // 2. The others do not move there
        for (unsigned int i = k + 1; i < modes.size(); ++i)
          modes[i].add(-modes[i][pin] / modes[k][pin], modes[k]);
      }
    return pins;
  }



  std::vector<FreeModes::Spring>
  FreeModes::springs(const std::vector<Spring> &held) const
  {
    const unsigned int  n = modes_.size();
    std::vector<Spring> result;
    if (n == 0)
      return result;
    LAPACKFullMatrix<double> stiffness(n);
    for (const auto &[row, spring] : held)
      for (unsigned int i = 0; i < n; ++i)
        for (unsigned int j = 0; j < n; ++j)
          stiffness(i, j) += spring * row.dot(modes_[i]) * row.dot(modes_[j]);
    InterfaceVector    values;
    FullMatrix<double> vectors;
    stiffness.compute_eigenvalues_symmetric(
      -1., weakest / softness, 1e-14, values, vectors);
    for (unsigned int k = 0; k < values.size(); ++k)
      {
        InterfaceVector direction(modes_.front().size());
        for (unsigned int i = 0; i < n; ++i)
          direction.add(vectors(i, k), duals_[i]);
        result.push_back({as_row(direction), 1.});
      }
    return result;
  }
} // namespace Signorini
