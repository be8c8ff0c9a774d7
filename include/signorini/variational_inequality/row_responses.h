#ifndef signorini_variational_inequality_row_responses_h
#define signorini_variational_inequality_row_responses_h

#include <signorini/variational_inequality/interface_stiffness.h>
#include <signorini/variational_inequality/interface_types.h>
#include <signorini/variational_inequality/sparse_row.h>

#include <functional>
#include <vector>

namespace Signorini
{
  /**
   * The displacements S^-1 a^T of the interface under a unit force along each
   * of a list of rows a, in m/N. A response is computed when it is first
   * asked for and kept until forget() or resize(). Not safe to share between
   * threads.
   */
  class RowResponses
  {
  public:
    /** Row @p k of the list. */
    using Rows = std::function<const SparseRow &(const unsigned int)>;

    /** Forgets the response of row @p k. */
    void
    forget(const unsigned int k);

    /** Forgets all responses. */
    void
    forget_all();

    /** Changes the length of the list; responses below it are kept. */
    void
    resize(const unsigned int n_rows);

    /** Is the response of row @p k at hand? */
    bool
    is_known(const unsigned int k) const
    {
      return known[k] != 0;
    }

    /** Computes the responses of @p wanted that are missing, all at once. */
    void
    compute(const InterfaceStiffness        &stiffness,
            const Rows                      &rows,
            const std::vector<unsigned int> &wanted);

    /** The response of row @p k, which must be known. */
    const InterfaceVector &
    operator[](const unsigned int k) const
    {
      Assert(is_known(k), dealii::ExcInternalError());
      return responses[k];
    }

  private:
    std::vector<char>            known;
    std::vector<InterfaceVector> responses;
  };
} // namespace Signorini

#endif
