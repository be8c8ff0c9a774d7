#include <signorini/variational_inequality/row_responses.h>

#include <algorithm>

namespace Signorini
{
  using namespace dealii;

  void
  RowResponses::forget(const unsigned int k)
  {
    AssertIndexRange(k, known.size());
    known[k] = 0;
  }



  void
  RowResponses::forget_all()
  {
    std::fill(known.begin(), known.end(), 0);
  }



  void
  RowResponses::resize(const unsigned int n_rows)
  {
    known.resize(n_rows, 0);
    responses.resize(n_rows);
  }



  void
  RowResponses::compute(const InterfaceStiffness        &stiffness,
                        const Rows                      &rows,
                        const std::vector<unsigned int> &wanted)
  {
    std::vector<unsigned int> missing;
    for (const unsigned int k : wanted)
      if (!is_known(k))
        missing.push_back(k);
    if (missing.empty())
      return;

    // One block: the triangular solves then run at the speed of a
    // matrix-matrix product. BLAS takes its columns in groups of up to eight,
    // and rounds those of a smaller last group in another way. With whole
    // groups a response does not depend on which others come with it, so that
    // a run that is resumed, and knows none, finds the same ones.
    const unsigned int  n         = stiffness.size();
    const unsigned int  n_columns = (missing.size() + 7) / 8 * 8;
    std::vector<double> columns(std::size_t(n) * n_columns, 0.);
    for (unsigned int c = 0; c < missing.size(); ++c)
      for (const auto &[dof, coefficient] : rows(missing[c]))
        columns[dof + std::size_t(c) * n] += coefficient;
    stiffness.solve_columns(columns, n_columns);

    for (unsigned int c = 0; c < missing.size(); ++c)
      {
        InterfaceVector &response = responses[missing[c]];
        response.reinit(n, /*omit_zeroing_entries=*/true);
        std::copy_n(columns.begin() + std::size_t(c) * n, n, response.begin());
        known[missing[c]] = 1;
      }
  }
} // namespace Signorini
