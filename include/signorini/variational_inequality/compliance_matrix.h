#ifndef signorini_variational_inequality_compliance_matrix_h
#define signorini_variational_inequality_compliance_matrix_h

#include <signorini/variational_inequality/dense_factor.h>
#include <signorini/variational_inequality/interface_types.h>

#include <functional>
#include <vector>

namespace Signorini
{
  /**
   * W_ij = b_i S^-1 b_j^T, m/N, between a list of rows b of an interface, and
   * the last factor made from it. In a time loop over flat targets neither
   * changes from step to step, so that a step with the states of the last one
   * pays for two triangular solves only.
   */
  class ComplianceMatrix
  {
  public:
    /** W_ij for the numbers of two rows. */
    using Entry = std::function<double(const unsigned int, const unsigned int)>;

    /** Forgets everything. */
    void
    clear();

    /** Is this the matrix of these rows, in this order? */
    bool
    holds(const std::vector<unsigned int> &row_numbers) const
    {
      return row_numbers == rows;
    }

    /** Becomes the matrix of the rows @p row_numbers, in this order. Entries
     * between rows that it held before are not computed again. */
    void
    set_rows(const std::vector<unsigned int> &row_numbers, const Entry &entry);

    const InterfaceMatrix &
    matrix() const
    {
      return W;
    }

    /** Belongs to the matrix: empty whenever that changed. */
    DenseFactor &
    factor()
    {
      return kept_factor;
    }

  private:
    std::vector<unsigned int> rows;
    InterfaceMatrix           W;
    DenseFactor               kept_factor;
  };
} // namespace Signorini

#endif
