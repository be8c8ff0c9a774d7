#ifndef signorini_contact_interface_numbering_h
#define signorini_contact_interface_numbering_h

#include <signorini/contact/contact_point.h>
#include <signorini/solid/dof_map.h>
#include <signorini/variational_inequality/interface_types.h>

#include <vector>

namespace Signorini
{
  /** A dense part of a stiffness that is sparse as a whole. */
  struct StiffnessBlock
  {
    std::vector<unsigned int> unknowns; // of the interface
    InterfaceMatrix           matrix;   // N/m

    void
    add_to(InterfaceMatrix &stiffness) const;
  };

  /**
   * The unknowns that contacts touch, counted in the order in which they are
   * added: those are the unknowns of the interface problem.
   */
  class InterfaceNumbering
  {
  public:
    /** @param dof_map must outlive the object */
    explicit InterfaceNumbering(const DofMap &dof_map);

    /**
     * Adds an unknown, or in place of that of a hanging node those that it
     * follows; what is fixed or known already changes nothing.
     */
    void
    add(const unsigned int unknown);

    /** All unknowns of the interface. */
    const std::vector<unsigned int> &
    unknowns() const
    {
      return unknowns_;
    }

    /** A row of all unknowns on those of the interface, times a factor. */
    SparseRow
    row(const SparseRow &of_all, const double factor) const;

    /** factor grad grad g on the unknowns of the interface. */
    StiffnessBlock
    block(const GapCurvature &curvature, const double factor) const;

  private:
    void
    add_free(const unsigned int unknown);

    const DofMap             &dof_map_;
    std::vector<unsigned int> unknowns_;
    std::vector<unsigned int> index_; // of all unknowns
  };
} // namespace Signorini

#endif
